// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/Blend_part.h"

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// Two matched parts that touch at both ends.
struct Kept_contact
{
  std::array<std::size_t, 2> parts;
  std::array<double, 2> gap; ///< by end, between the surfaces

  /// How wide the gap may be at `t`.
  double allowed_gap(double t) const { return (1 - t) * gap[0] + t * gap[1]; }
};

/// The contacts that matched parts have at both ends, as the graphs have them: of pieces of a part, those that are
/// near.
/// \param tolerance what is nearer than this touches
std::vector<Kept_contact> contacts_to_keep(const Blend_stage& stage, const std::vector<Blend_part>& parts,
                                           double tolerance);

} // namespace CGAL::Shape_correspondence::internal

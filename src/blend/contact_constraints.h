// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/Blend_part.h"

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

struct Blend_ends;
struct Blend_input;

/// Two matched parts that are to be near each other.
struct Contact_constraint
{
  std::array<std::size_t, 2> parts;
  std::array<bool, 2> touch = {false, false}; ///< by end
  std::array<double, 2> gap = {0, 0};         ///< by end

  /// How wide the gap may be at `t`. A contact that both ends have goes from the one to the other. One of one end only
  /// lasts for its half of the blend and comes about, or is given up, in the other; one of neither end, which takes the
  /// place of unmatched parts that join the two, has come about in the middle.
  double allowed_gap(double t) const;
};

/// The contacts that are to be kept: those of both ends, and of either end as many more as it takes to join the
/// components that they leave, those first that come apart least; then the shortest connections of what is left apart.
/// Mirror images have the same ones.
/// \param tolerance what is nearer than this touches
std::vector<Contact_constraint> contact_constraints(const std::array<Blend_input, 2>& inputs, const Blend_ends& ends,
                                                    const std::vector<Blend_part>& parts, double tolerance);

} // namespace CGAL::Shape_correspondence::internal

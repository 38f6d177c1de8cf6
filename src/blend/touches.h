// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/Blend_part.h"

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// Two parts of a blend that touch at an end, or at both.
struct Touch
{
  static constexpr double none = std::numeric_limits<double>::infinity();

  std::array<std::size_t, 2> parts;
  std::array<double, 2> gaps = {none, none}; ///< between the surfaces, by end; `none` where they do not touch

  bool is_kept() const { return gaps[0] < none && gaps[1] < none; }
};

/// What touches, as the graphs have it: of pieces of a part, those that are near.
/// \param tolerance what is nearer than this touches
std::vector<Touch> touches(const Blend_stage& stage, const std::vector<Blend_part>& parts, double tolerance);

/// By part, what it shrinks to and grows from if it is not matched: the middle of the places where matched parts hold
/// it and the unmatched parts that hang together with it, or the foot of these if nothing holds them.
std::vector<Point> roots(const std::vector<Blend_part>& parts, const std::vector<Touch>& touches);

} // namespace CGAL::Shape_correspondence::internal

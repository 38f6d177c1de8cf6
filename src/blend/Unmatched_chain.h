// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/Blend_part.h"
#include "blend/touches.h"

#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

struct Blend_stage;

/// Unmatched parts of an end that touch each other: they come or go as one.
struct Unmatched_chain
{
  int end = 0;
  std::vector<std::size_t> parts; ///< of the blend
  Point root = Point::Zero();     ///< what it shrinks to, and grows from

  /// Points of it when a share of it remains, in [0, 1].
  Points shrunk(const Points& points, double remaining) const
  {
    return (remaining * (points.colwise() - root)).colwise() + root;
  }
};

/// The chains of the parts that are not matched.
std::vector<Unmatched_chain> unmatched_chains(const Blend_stage& stage, const std::vector<Blend_part>& parts,
                                              const std::vector<Touch>& touches);

} // namespace CGAL::Shape_correspondence::internal

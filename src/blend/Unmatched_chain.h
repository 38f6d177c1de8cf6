// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/Blend_part.h"

#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// Where a chain touches a matched part.
struct Anchor
{
  Point at;
  std::size_t carrier; ///< the matched part
  Point coordinates;   ///< of that, there
};

/// Unmatched parts of an end that hold together: they go with the matched parts that they touch, and come or go as one
/// body.
struct Unmatched_chain
{
  int end;
  std::vector<std::size_t> parts; ///< of the blend
  std::vector<Anchor> anchors;
  contacts::Box box;
  Point root; ///< what it shrinks to, and grows from

  bool stands() const { return box.min().y() <= Blend_part::on_ground; }
  /// Points of it when a share of it remains, in [0, 1].
  Points shrunk(const Points& points, double remaining) const
  {
    return (remaining * (points.colwise() - root)).colwise() + root;
  }
};

/// Adds the parts of both ends that become no part.
/// \param unlike pairs that correspond but do not morph
/// \param parts gets them
std::vector<Unmatched_chain> add_unmatched_parts(const Blend_stage& stage, const Unlike_pairs& unlike,
                                                 std::vector<Blend_part>& parts);

} // namespace CGAL::Shape_correspondence::internal

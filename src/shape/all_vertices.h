// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// The points of all sets, one set after the other.
inline Points joined(const std::vector<const Points*>& sets)
{
  Eigen::Index count = 0;
  for (const Points* points : sets)
    count += points->cols();
  Points result(3, count);
  for (const Points* points : sets) {
    result.middleCols(result.cols() - count, points->cols()) = *points;
    count -= points->cols();
  }
  return result;
}

/// The vertices of all parts, part by part.
inline Points all_vertices(const Segmented_shape& shape)
{
  std::vector<const Points*> sets;
  for (const Shape_part& part : shape.parts())
    sets.push_back(&part.mesh.points);
  return joined(sets);
}

} // namespace CGAL::Shape_correspondence::internal

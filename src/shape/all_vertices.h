// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Segmented_shape.h>

namespace CGAL::Shape_correspondence::internal {

/// The vertices of all parts, part by part.
inline Points all_vertices(const Segmented_shape& shape)
{
  Eigen::Index count = 0;
  for (const Shape_part& part : shape.parts())
    count += part.mesh.points.cols();
  Points result(3, count);
  for (const Shape_part& part : shape.parts()) {
    result.middleCols(result.cols() - count, part.mesh.points.cols()) = part.mesh.points;
    count -= part.mesh.points.cols();
  }
  return result;
}

} // namespace CGAL::Shape_correspondence::internal

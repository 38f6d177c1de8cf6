// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <Eigen/Geometry>

namespace CGAL::Shape_correspondence::internal {

/// Whether a mesh has a surface to speak of, not just slivers.
inline bool has_area(const Part_mesh& mesh)
{
  // Relative to the squared extent, so that the unit of length does not matter.
  const double smallest = 1e-14;
  const double extent = (mesh.points.rowwise().maxCoeff() - mesh.points.rowwise().minCoeff()).norm();
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
    const Point a = mesh.points.col(mesh.triangles(0, t));
    const Point b = mesh.points.col(mesh.triangles(1, t));
    const Point c = mesh.points.col(mesh.triangles(2, t));
    if ((b - a).cross(c - a).norm() > smallest * extent * extent) {
      return true;
    }
  }
  return false;
}

} // namespace CGAL::Shape_correspondence::internal

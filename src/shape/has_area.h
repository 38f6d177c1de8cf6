// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_SHAPE_HAS_AREA_H
#define CGAL_SHAPE_CORRESPONDENCE_SHAPE_HAS_AREA_H

#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <Eigen/Geometry>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

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

} // namespace internal
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_SHAPE_HAS_AREA_H

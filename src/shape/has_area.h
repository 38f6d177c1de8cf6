// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "shape/oriented_box.h"
#include "shape/triangle_distance.h"

namespace CGAL::Shape_correspondence::internal {

/// Whether a mesh has an area above rounding noise, not only slivers.
inline bool has_area(const Part_mesh& mesh)
{
  // Relative to the squared extent, so that the unit of length does not matter.
  const double smallest = 1e-14;
  const double extent = diagonal(mesh.points);
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t)
    if (contacts::area_vector(triangle_of(mesh, t)).norm() > smallest * extent * extent) return true;
  return false;
}

} // namespace CGAL::Shape_correspondence::internal

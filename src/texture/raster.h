// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "base/clamped.h"
#include "base/planar_hull.h"

#include <Eigen/Core>

#include <array>

namespace CGAL::Shape_correspondence::internal {

/// The corners of a triangle in a picture, in pixels.
using Flat_triangle = std::array<Eigen::Vector2d, 3>;

/// Barycentric coordinates of a point; not finite for a triangle without area.
inline Eigen::Vector3d barycentric_coordinates(const Flat_triangle& t, const Eigen::Vector2d& p)
{
  const double area = cross(t[1] - t[0], t[2] - t[0]);
  const double a = cross(t[1] - p, t[2] - p) / area, b = cross(t[2] - p, t[0] - p) / area;
  return {a, b, 1 - a - b};
}

/// Calls `visit(x, y)` for the pixels of a square picture whose middle is in the triangle.
/// \param inside the least barycentric coordinate: more than 0 leaves out those on its border, which are on another
/// triangle's, too
template <typename Visit>
void for_each_pixel(const Flat_triangle& t, int size, const Visit& visit, double inside = -1e-9)
{
  const Eigen::Vector2d low = t[0].cwiseMin(t[1]).cwiseMin(t[2]), high = t[0].cwiseMax(t[1]).cwiseMax(t[2]);
  const int last = size - 1;
  for (int y = clamped_cell(low.y(), last); y <= clamped_cell(high.y(), last); ++y)
    for (int x = clamped_cell(low.x(), last); x <= clamped_cell(high.x(), last); ++x)
      if (barycentric_coordinates(t, {x + 0.5, y + 0.5}).minCoeff() >= inside) visit(x, y);
}

} // namespace CGAL::Shape_correspondence::internal

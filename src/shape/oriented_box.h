// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "base/eigen_system.h"

#include <CGAL/Shape_correspondence/Points.h>
#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <algorithm>
#include <array>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// The diagonal of the axis-parallel bounding box; 0 if there are no points.
inline double diagonal(const Points& points)
{
  return points.cols() == 0 ? 0. : (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).norm();
}

/// A box with its axes (columns) in the order of their extents, longest first.
struct Oriented_box
{
  Point centre;
  Eigen::Matrix3d axes;
  Eigen::Vector3d extents;
};

inline Oriented_box box_along(const Points& points, const Eigen::Matrix3d& axes)
{
  const Points turned = axes.transpose() * points;
  const Eigen::Vector3d low = turned.rowwise().minCoeff(), high = turned.rowwise().maxCoeff();
  std::array<int, 3> order{0, 1, 2};
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return high[a] - low[a] > high[b] - low[b]; });
  Oriented_box result;
  result.centre = axes * (0.5 * (low + high));
  for (int k = 0; k < 3; ++k) {
    result.axes.col(k) = axes.col(order[std::size_t(k)]);
    result.extents[k] = (high - low)[order[std::size_t(k)]];
  }
  return result;
}

/// The box along the coordinate axes, or along the principal axes where that is clearly tighter.
inline Oriented_box oriented_box(const Points& points)
{
  const Points centred = points.colwise() - points.rowwise().mean();
  const Oriented_box straight = box_along(points, Eigen::Matrix3d::Identity());
  const Oriented_box principal = box_along(points, eigen_system(scatter_matrix(centred)).vectors);
  const auto half_surface = [](const Oriented_box& box) {
    return box.extents[0] * box.extents[1] + box.extents[1] * box.extents[2] + box.extents[2] * box.extents[0];
  };
  return half_surface(principal) < 0.9 * half_surface(straight) ? principal : straight;
}

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

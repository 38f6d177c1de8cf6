// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "base/eigen_system.h"

#include <CGAL/Shape_correspondence/Part_abstraction.h>

#include <algorithm>
#include <array>

namespace CGAL::Shape_correspondence::internal {

/// The diagonal of the axis-parallel bounding box; 0 of no points.
inline double diagonal(const Points& points)
{
  return points.cols() == 0 ? 0. : (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).norm();
}

/// A box with its axes in the order of their extents, longest first.
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
    result.axes.col(k) = axes.col(order[static_cast<std::size_t>(k)]);
    result.extents[k] = (high - low)[order[static_cast<std::size_t>(k)]];
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

/// The line through the middle of a box along one of its axes.
inline Curve medial_curve(const Oriented_box& box, int control_points, Eigen::Index axis = 0)
{
  Curve result;
  result.points.resize(3, control_points);
  for (int i = 0; i < control_points; ++i) {
    const double t = i / (control_points - 1.) - 0.5;
    result.points.col(i) = box.centre + t * box.extents[axis] * box.axes.col(axis);
  }
  return result;
}

/// The axis along which a block is least like along the two others, as that of a square prism; of a cube the upright
/// one.
inline Eigen::Index distinct_axis(const Oriented_box& box)
{
  const double alike = 0.9;
  Eigen::Index result = box.extents[0] * box.extents[2] > box.extents[1] * box.extents[1] ? 0 : 2;
  if (box.extents[2] > alike * box.extents[0]) {
    box.axes.row(1).cwiseAbs().maxCoeff(&result);
  }
  return result;
}

inline Sheet medial_sheet(const Oriented_box& box, int n)
{
  Sheet result;
  result.rows = result.cols = n;
  result.points.resize(3, static_cast<Eigen::Index>(n) * n);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const double u = i / (n - 1.) - 0.5, v = j / (n - 1.) - 0.5;
      result.points.col(i * n + j) =
          box.centre + u * box.extents[0] * box.axes.col(0) + v * box.extents[1] * box.axes.col(1);
    }
  }
  return result;
}

inline bool is_flat(const Eigen::Vector3d& extents)
{
  return extents[1] > 0.2 * extents[0] && extents[2] < 0.5 * extents[1];
}

inline bool is_compact(const Eigen::Vector3d& extents)
{
  return extents[1] > 0.2 * extents[0] && extents[2] >= 0.5 * extents[1];
}

} // namespace CGAL::Shape_correspondence::internal

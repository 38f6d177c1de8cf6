// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "shape/oriented_box.h"

#include <CGAL/Shape_correspondence/Part_abstraction.h>

namespace CGAL::Shape_correspondence::internal {

/// The line through the centre of a box along one of its axes.
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

/// The axis of a box, as of a square prism, whose extent differs most from the other two; for a cube, the upright one.
inline Eigen::Index distinct_axis(const Oriented_box& box)
{
  const double alike = 0.9;
  Eigen::Index result = box.extents[0] * box.extents[2] > box.extents[1] * box.extents[1] ? 0 : 2;
  if (box.extents[2] > alike * box.extents[0]) box.axes.row(1).cwiseAbs().maxCoeff(&result);
  return result;
}

inline Sheet medial_sheet(const Oriented_box& box, int n)
{
  Sheet result;
  result.rows = result.cols = n;
  result.points.resize(3, Eigen::Index(n) * n);
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

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <Eigen/Core>

#include <array>

namespace CGAL::Shape_correspondence::internal {

// The boxes of all parts, one a row.
struct Boxes
{
  Eigen::ArrayX3d low, high;
};

// The same with what their costs need of one shape alone.
struct Measured_boxes : Boxes
{
  Eigen::ArrayXd volumes;
  Eigen::ArrayX3d logs; // of the extents

  Measured_boxes() = default;
  Measured_boxes(const Boxes& boxes, double tolerance);
};

// How much the ends of boxes move with each other in a warp, along each axis: 1 at the same place, less with distance,
// in units of `width`. Of part i, the low end is number 2 i and the high end number 2 i + 1.
class Closeness
{
public:
  Closeness() = default;
  Closeness(const Boxes& boxes, double width);

  // Of an end to all ends. They are kept, or found anew in `room`, with the same bits
  const double* of_end(int axis, Eigen::Index end, Eigen::ArrayXd& room) const;

private:
  double width_ = 1;
  std::array<Eigen::ArrayXd, 3> ends_;
  std::array<Eigen::MatrixXd, 3> kept_; // an end a column, symmetric; empty for shapes of many parts
};

} // namespace CGAL::Shape_correspondence::internal

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <Eigen/Core>

#include <limits>

namespace CGAL::Shape_correspondence::internal {

// Points as arrays of x, y and z, padded with points at infinity.
class Point_lanes
{
public:
  static constexpr Eigen::Index block_lanes = 8; // number of doubles in the widest vector register

  explicit Point_lanes(const Eigen::ArrayX3d& points)
      : count_(points.rows()), coordinates_((points.rows() + block_lanes - 1) / block_lanes * block_lanes, 3)
  {
    coordinates_.setConstant(std::numeric_limits<double>::infinity());
    coordinates_.topRows(count_) = points;
  }

  Eigen::Index count() const { return count_; }
  Eigen::Index padded() const { return coordinates_.rows(); }
  const double* operator[](int axis) const { return coordinates_.col(axis).data(); }

private:
  Eigen::Index count_;
  Eigen::ArrayX3d coordinates_;
};

// The least distance of every point of `p` from `q`, and of every point of `q` from `p`; computed together, since they
// need the same distances. The two result arrays have room for the padding, too. Every instruction set gives the same
// bits: a squared distance is x² + y² + z² in that order, and a minimum does not depend on the order.
void find_nearest(const Point_lanes& p, const Point_lanes& q, double* p_from_q, double* q_from_p);

} // namespace CGAL::Shape_correspondence::internal

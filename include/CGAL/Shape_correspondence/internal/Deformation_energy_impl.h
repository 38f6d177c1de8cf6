// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_INTERNAL_DEFORMATION_ENERGY_IMPL_H
#define CGAL_SHAPE_CORRESPONDENCE_INTERNAL_DEFORMATION_ENERGY_IMPL_H

#include <CGAL/Shape_correspondence/Deformation_energy.h>
#include <CGAL/Shape_correspondence/internal/quantized.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

// Rods computed at a time: sample counts, e and e × e, are multiples of it
constexpr int rod_lanes = 6;
using Rod_lanes = Eigen::Array<double, rod_lanes, 1>;

// A coordinate of all points, the last one repeated up to a multiple of `rod_lanes`.
inline Eigen::ArrayXd padded_row(const Points& points, int row)
{
  const Eigen::Index m = points.cols(), padded = (m + rod_lanes - 1) / rod_lanes * rod_lanes;
  Eigen::ArrayXd result = Eigen::ArrayXd::Constant(padded, points(row, m - 1));
  result.head(m) = points.row(row);
  return result;
}

} // namespace internal

CGAL_SHAPE_CORRESPONDENCE_INLINE Structural_rods::Structural_rods(const Points& first, const Points& second)
{
  const Eigen::ArrayXd sx = internal::padded_row(second, 0), sy = internal::padded_row(second, 1),
                       sz = internal::padded_row(second, 2);
  const Eigen::Index n = first.cols(), m = second.cols(), padded = sx.size();
  x_.resize(n * padded), y_.resize(n * padded), z_.resize(n * padded);
  for (Eigen::Index i = 0; i < n; ++i) {
    x_.segment(i * padded, padded) = sx - first(0, i);
    y_.segment(i * padded, padded) = sy - first(1, i);
    z_.segment(i * padded, padded) = sz - first(2, i);
  }
  squared_length_ = x_ * x_ + y_ * y_ + z_ * z_;
  shortest_ = squared_length_.minCoeff();
  longest_ = std::sqrt(squared_length_.maxCoeff());

  // Infinite length takes a rod out of the sum: those without a direction, which count as kept, and the padding
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < padded; ++j) {
      double& length = squared_length_[i * padded + j];
      if (j < m && length >= internal::zero_squared_length) continue;
      length = std::numeric_limits<double>::infinity();
      if (j < m) directionless_ += 1;
    }
}

// Several independent sums let the compiler use vector instructions,
// and fix the order of summation.
CGAL_SHAPE_CORRESPONDENCE_INLINE Rod_energy Structural_rods::energy(const Points& first, const Points& second) const
{
  const Eigen::ArrayXd sx = internal::padded_row(second, 0), sy = internal::padded_row(second, 1),
                       sz = internal::padded_row(second, 2);
  const Eigen::Index n = first.cols(), m = second.cols(), padded = sx.size();
  // D_ij² is computed as dot² / (|r|² |r'|²), which is exactly 1 for an unmoved rod
  internal::Rod_lanes sum = internal::Rod_lanes::Zero();
  internal::Rod_lanes nearest = internal::Rod_lanes::Constant(std::numeric_limits<double>::infinity());
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < padded; j += internal::rod_lanes) {
      const Eigen::Index rod = i * padded + j;
      const auto x = sx.segment<internal::rod_lanes>(j) - first(0, i);
      const auto y = sy.segment<internal::rod_lanes>(j) - first(1, i);
      const auto z = sz.segment<internal::rod_lanes>(j) - first(2, i);
      const internal::Rod_lanes moved = x * x + y * y + z * z;
      const internal::Rod_lanes dot =
          (x_.segment<internal::rod_lanes>(rod) * x + y_.segment<internal::rod_lanes>(rod) * y +
           z_.segment<internal::rod_lanes>(rod) * z)
              .max(0.0);
      sum += dot * dot / (squared_length_.segment<internal::rod_lanes>(rod) * moved.max(internal::zero_squared_length));
      nearest = nearest.min(moved);
    }

  Rod_energy result;
  result.distortion = 1 - std::min(1.0, std::sqrt((directionless_ + sum.sum()) / double(n * m)));
  const double closest = nearest.minCoeff();
  if (closest > shortest_) result.connectedness = longest_ > 0 ? std::min(1.0, std::sqrt(closest) / longest_) : 1.0;
  return result;
}

CGAL_SHAPE_CORRESPONDENCE_INLINE double split_energy(const std::vector<double>& solidity_ratios)
{
  if (solidity_ratios.empty()) return 0;
  double sum = 0;
  for (double s : solidity_ratios)
    sum += s * s;
  return 1 - std::sqrt(sum / double(solidity_ratios.size()));
}

CGAL_SHAPE_CORRESPONDENCE_INLINE double weighted_sum(const Energy_terms& terms, const Energy_weights& weights)
{
  return terms.distortion + weights.connectedness * terms.connectedness + weights.split * terms.split;
}

} // namespace Shape_correspondence
} // namespace CGAL

#endif

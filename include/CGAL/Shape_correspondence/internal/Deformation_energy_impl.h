// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_INTERNAL_DEFORMATION_ENERGY_IMPL_H
#define CGAL_SHAPE_CORRESPONDENCE_INTERNAL_DEFORMATION_ENERGY_IMPL_H

#include <CGAL/Shape_correspondence/Deformation_energy.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

// Squared length, in units of the shape's height, under which a rod has no direction
constexpr double zero_squared_length = 1e-18;

} // namespace internal

CGAL_SHAPE_CORRESPONDENCE_INLINE Structural_rods::Structural_rods(const Points& first, const Points& second)
{
  const Eigen::Index n = first.cols(), m = second.cols();
  x_.resize(n * m), y_.resize(n * m), z_.resize(n * m);
  for (Eigen::Index i = 0; i < n; ++i) {
    x_.segment(i * m, m) = second.row(0).transpose().array() - first(0, i);
    y_.segment(i * m, m) = second.row(1).transpose().array() - first(1, i);
    z_.segment(i * m, m) = second.row(2).transpose().array() - first(2, i);
  }
  squared_length_ = x_ * x_ + y_ * y_ + z_ * z_;
  shortest_ = squared_length_.minCoeff();
  longest_ = std::sqrt(squared_length_.maxCoeff());
}

CGAL_SHAPE_CORRESPONDENCE_INLINE Rod_energy Structural_rods::energy(const Points& first, const Points& second) const
{
  const Eigen::Index n = first.cols(), m = second.cols();
  const Eigen::ArrayXd sx = second.row(0), sy = second.row(1), sz = second.row(2);
  double sum = 0; // of D_ij², as dot² / (|r|² |r'|²): exactly 1 for an unmoved rod
  double nearest = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < n; ++i) {
    const double fx = first(0, i), fy = first(1, i), fz = first(2, i);
    const double *rx = x_.data() + i * m, *ry = y_.data() + i * m, *rz = z_.data() + i * m;
    const double* length = squared_length_.data() + i * m;
    for (Eigen::Index j = 0; j < m; ++j) {
      const double x = sx[j] - fx, y = sy[j] - fy, z = sz[j] - fz;
      const double moved = x * x + y * y + z * z;
      nearest = std::min(nearest, moved);
      if (length[j] < internal::zero_squared_length)
        sum += 1;
      else if (moved >= internal::zero_squared_length) {
        const double dot = std::max(0.0, rx[j] * x + ry[j] * y + rz[j] * z);
        sum += dot * dot / (length[j] * moved);
      }
    }
  }
  Rod_energy result;
  result.distortion = 1 - std::min(1.0, std::sqrt(sum / double(n * m)));
  if (nearest > shortest_) result.connectedness = longest_ > 0 ? std::min(1.0, std::sqrt(nearest) / longest_) : 1.0;
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

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_INTERNAL_DEFORMATION_ENERGY_IMPL_H
#define CGAL_SHAPE_CORRESPONDENCE_INTERNAL_DEFORMATION_ENERGY_IMPL_H

#include <CGAL/Shape_correspondence/Deformation_energy.h>
#include <CGAL/Shape_correspondence/internal/quantized.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

// The side with fewer samples gives the rows; where all rods fit into one row, they are its lanes.
inline bool rods_fit_one_row(int first_count, int second_count) { return first_count * second_count <= lane_count; }

// The vectors from every sample of the first to every sample of the second, as lanes.
inline Sample_lanes rods_as_lanes(const Sample_lanes& first, int first_count, const Sample_lanes& second,
                                  int second_count)
{
  Sample_lanes result;
  for (int axis = 0; axis < 3; ++axis) {
    const float *from = first.coordinates[axis], *to = second.coordinates[axis];
    float* rod = result.coordinates[axis];
    for (int i = 0; i < first_count; ++i)
      for (int j = 0; j < second_count; ++j)
        rod[i * second_count + j] = to[j] - from[i];
    std::fill(rod + first_count * second_count, rod + lane_count, 0.0f);
  }
  return result;
}

} // namespace internal

CGAL_SHAPE_CORRESPONDENCE_INLINE Structural_rods::Structural_rods(const Points& first, const Points& second)
    : first_count_(int(first.cols())), second_count_(int(second.cols()))
{
  using namespace internal;
  CGAL_precondition(first_count_ <= maximum_samples && second_count_ <= maximum_samples);
  const Sample_lanes a(first), b(second);
  const bool one_row = rods_fit_one_row(first_count_, second_count_), turned = first_count_ > second_count_;
  const Sample_lanes from = one_row ? Sample_lanes(Points::Zero(3, 1)) : turned ? b : a;
  const Sample_lanes to = one_row ? rods_as_lanes(a, first_count_, b, second_count_) : turned ? a : b;
  const int rows = one_row ? 1 : std::min(first_count_, second_count_);
  const int lanes = first_count_ * second_count_ / rows;

  double longest = 0;
  rows_.resize(std::size_t(rows));
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < lane_count; ++j) {
      Rod_row& row = rows_[std::size_t(i)];
      for (int axis = 0; axis < 3; ++axis)
        row.direction[axis][j] = j < lanes ? to.coordinates[axis][j] - from.coordinates[axis][i] : 0.0f;
      float& length = row.squared_length[j];
      length = squared_rod_length(row.direction[0][j], row.direction[1][j], row.direction[2][j]);
      if (j < lanes) {
        longest = std::max(longest, double(length));
        directionless_ += length < zero_rod;
      }
      if (j < lanes && length >= zero_rod) continue;
      length = 1;
      row.direction[0][j] = row.direction[1][j] = row.direction[2][j] = 0;
    }
  longest_ = std::sqrt(longest);
  shortest_ = least_distance(first, second);
}

CGAL_SHAPE_CORRESPONDENCE_INLINE double Structural_rods::distortion(const internal::Sample_lanes& first,
                                                                    const internal::Sample_lanes& second) const
{
  using namespace internal;
  const auto kernel = rod_kernels().squared_cosines;
  static const Sample_lanes origin(Points::Zero(3, 1));
  const int row_count = int(rows_.size());
  double kept = directionless_;
  if (rods_fit_one_row(first_count_, second_count_))
    kept += kernel(rows_.data(), row_count, origin, rods_as_lanes(first, first_count_, second, second_count_));
  else if (first_count_ > second_count_)
    kept += kernel(rows_.data(), row_count, second, first);
  else
    kept += kernel(rows_.data(), row_count, first, second);
  return 1 - std::min(1.0, std::sqrt(kept / (double(first_count_) * second_count_)));
}

CGAL_SHAPE_CORRESPONDENCE_INLINE double Structural_rods::connectedness(double distance) const
{
  if (distance <= shortest_ + internal::comparison_grid) return 0;
  return longest_ > 0 ? std::min(1.0, distance / longest_) : 1.0;
}

CGAL_SHAPE_CORRESPONDENCE_INLINE Rod_energy Structural_rods::energy(const Points& first, const Points& second) const
{
  CGAL_precondition(first.cols() == first_count_ && second.cols() == second_count_);
  return {distortion(internal::Sample_lanes(first), internal::Sample_lanes(second)),
          connectedness(least_distance(first, second))};
}

CGAL_SHAPE_CORRESPONDENCE_INLINE double least_distance(const Points& first, const Points& second)
{
  CGAL_precondition(first.cols() <= internal::maximum_samples && second.cols() <= internal::maximum_samples);
  return least_distance(internal::Sample_lanes(first), int(first.cols()), internal::Sample_lanes(second));
}

CGAL_SHAPE_CORRESPONDENCE_INLINE double least_distance(const internal::Sample_lanes& first, int first_count,
                                                       const internal::Sample_lanes& second)
{
  return std::sqrt(double(internal::rod_kernels().least_squared_distance(first, first_count, second)));
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
  return weights.distortion * terms.distortion + weights.connectedness * terms.connectedness +
         weights.split * terms.split + terms.unmatched;
}

} // namespace Shape_correspondence
} // namespace CGAL

#endif

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "energy/Structural_rods.h"
#include "energy/rod_cosines.h"

#include <CGAL/Shape_correspondence/Deformation_energy.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace CGAL::Shape_correspondence {
using namespace internal;

namespace {

// Appends the rods from a sample to the first `count` samples of `to`. Returns how many have no direction.
int append_row(const Point& from, const Points& to, int count, std::vector<Rod_block>& rods)
{
  int directionless = 0;
  for (int j = 0; j < count; ++j) {
    if (j % block_lanes == 0) rods.push_back({});
    const Point rod = to.col(j) - from;
    if (rod.squaredNorm() < double(zero_rod)) {
      ++directionless;
      continue;
    }
    const Point direction = rod.normalized();
    for (int axis = 0; axis < 3; ++axis)
      rods.back().direction[axis][j % block_lanes] = float(direction[axis]);
  }
  return directionless;
}

} // namespace

void Structural_rods::assign(const Points& first, const Points& second)
{
  first_count_ = int(first.cols());
  second_count_ = int(second.cols());
  CGAL_precondition(first_count_ <= maximum_samples && second_count_ <= maximum_samples);
  const int in_blocks = samples_in_blocks(second_count_);
  rods_.clear();
  rods_.reserve(
      std::size_t(first_count_ * blocks_of(in_blocks) + (second_count_ - in_blocks) * blocks_of(first_count_)));
  int directionless = 0;
  for (int i = 0; i < first_count_; ++i)
    directionless += append_row(first.col(i), second, in_blocks, rods_);
  for (int j = in_blocks; j < second_count_; ++j)
    directionless += append_row(second.col(j), first, first_count_, rods_);
  directionless_ = double(directionless) / (first_count_ * second_count_);
  const Rod_block* rods = rods_.data();
  const Rod_answer<1> unmoved =
      rod_kernels().both(&rods, Sample_lanes(first), first_count_, Sample_lanes(second), second_count_);
  unmoved_ = double(unmoved.squared_cosines[0]);
  shortest_ = std::sqrt(double(unmoved.least_squared_length));
  longest_ = 0;
  for (int j = 0; j < second_count_; ++j)
    longest_ = std::max(longest_, (first.colwise() - second.col(j)).colwise().norm().maxCoeff());
}

double Structural_rods::distortion(float squared_cosines) const
{
  if (unmoved_ == 0) return 0;
  return distortion_energy(directionless_ + (1 - directionless_) * (double(squared_cosines) / unmoved_));
}

void distortions(const std::vector<const Structural_rods*>& pairs, const Sample_lanes& first,
                 const Sample_lanes& second, std::vector<double>& result)
{
  const Rod_kernels& kernels = rod_kernels();
  std::size_t done = 0;
  result.resize(pairs.size());
  const auto compare = [&](const auto& kernel, auto count) {
    const Rod_block* rods[decltype(count)::value];
    for (std::size_t i = 0; i < count; ++i)
      rods[i] = pairs[done + i]->rods_.data();
    const auto moved = kernel(rods, first, pairs[0]->first_count_, second, pairs[0]->second_count_);
    for (std::size_t i = 0; i < count; ++i, ++done)
      result[done] = pairs[done]->distortion(moved.squared_cosines[i]);
  };
  while (pairs.size() - done >= 4)
    compare(kernels.four, std::integral_constant<std::size_t, 4>());
  if (pairs.size() - done >= 2) compare(kernels.two, std::integral_constant<std::size_t, 2>());
  if (pairs.size() > done) compare(kernels.one, std::integral_constant<std::size_t, 1>());
}

double Structural_rods::connectedness(double distance) const
{
  return connectedness_energy(shortest_, distance, longest_);
}

Rod_energy Structural_rods::energy(const Sample_lanes& first, const Sample_lanes& second) const
{
  const Rod_block* rods = rods_.data();
  const Rod_answer<1> moved = rod_kernels().both(&rods, first, first_count_, second, second_count_);
  return {distortion(moved.squared_cosines[0]), connectedness(std::sqrt(double(moved.least_squared_length)))};
}

Rod_energy Structural_rods::energy(const Points& first, const Points& second) const
{
  CGAL_precondition(first.cols() == first_count_ && second.cols() == second_count_);
  return energy(Sample_lanes(first), Sample_lanes(second));
}

double least_distance(const Points& first, const Points& second)
{
  CGAL_precondition(first.cols() <= maximum_samples && second.cols() <= maximum_samples);
  return least_distance(Sample_lanes(first), int(first.cols()), Sample_lanes(second), int(second.cols()));
}

double least_distance(const Sample_lanes& first, int first_count, const Sample_lanes& second, int second_count)
{
  return std::sqrt(
      double(rod_kernels().least_length(nullptr, first, first_count, second, second_count).least_squared_length));
}

} // namespace CGAL::Shape_correspondence

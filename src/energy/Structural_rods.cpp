// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "energy/Structural_rods.h"
#include "base/quantized.h"
#include "energy/rod_cosines.h"
#include "energy/rod_directions.h"

#include <CGAL/Shape_correspondence/Deformation_energy.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

namespace CGAL::Shape_correspondence {
using namespace internal;

std::size_t Structural_rods::size(int first_count, int second_count)
{
  const int in_blocks = samples_in_blocks(second_count);
  return std::size_t(first_count) * std::size_t(blocks_of(in_blocks)) +
         std::size_t(second_count - in_blocks) * std::size_t(blocks_of(first_count));
}

Structural_rods::Structural_rods(const Points& first, const Points& second, int first_repeats, int second_repeats)
    : Structural_rods(first, second, first_repeats, second_repeats,
                      own_rods(size(int(first.cols()) * first_repeats, int(second.cols()) * second_repeats)))
{}

Structural_rods::Structural_rods(const Points& first, const Points& second, int first_repeats, int second_repeats,
                                 Own_rods memory)
    : Structural_rods(Sample_lanes(first, first_repeats), int(first.cols()) * first_repeats,
                      Sample_lanes(second, second_repeats), int(second.cols()) * second_repeats, memory.get())
{
  memory_ = std::move(memory);
}

Structural_rods::Structural_rods(const Sample_lanes& from, int first_count, const Sample_lanes& to, int second_count,
                                 Rod_block* memory)
    : rods_(memory), first_count_(first_count), second_count_(second_count)
{
  CGAL_precondition(first_count_ <= maximum_samples && second_count_ <= maximum_samples);
  const int in_blocks = samples_in_blocks(second_count_);
  static const Rod_writer write = available_rod_writers().back();
  const Rod_rows there = write(from, 0, first_count_, to, in_blocks, memory);
  memory += std::ptrdiff_t(first_count_) * blocks_of(in_blocks);
  const Rod_rows back = write(to, in_blocks, second_count_, from, first_count_, memory);
  directionless_ = there.directionless + back.directionless;
  share_ = 1 / double(first_count_ * second_count_);
  shortest_ = std::sqrt(double(std::min(there.shortest_squared, back.shortest_squared)));
  longest_ = std::sqrt(double(std::max(there.longest_squared, back.longest_squared)));
}

double Structural_rods::distortion(float squared_cosines) const
{
  const double mean = (directionless_ + double(squared_cosines)) * share_;
  return mean > 1 - comparison_grid ? 0 : distortion_energy(mean);
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
      rods[i] = pairs[done + i]->rods_;
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
  const Rod_answer<1> moved = rod_kernels().both(&rods_, first, first_count_, second, second_count_);
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

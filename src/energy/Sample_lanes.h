// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Points.h>

#include <algorithm>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

constexpr int maximum_samples = 36; // of a part: e × e
constexpr int block_lanes = 16;     // of the widest vectors
constexpr int maximum_blocks = 3;
constexpr int lane_count = block_lanes * maximum_blocks;

// Padding behind the points: finite, so that a rod to it can be taken out, and nearest to nothing
constexpr float far_away = 1e6f;

// Up to `maximum_samples` points, coordinate by coordinate, then padding.
struct alignas(64) Sample_lanes
{
  float coordinates[3][lane_count];
  int repeats, stride = 1; // so many samples are equal each: those that are `stride` apart

  explicit Sample_lanes(const Points& samples, int repeats = 1) : repeats(repeats)
  {
    const int count = int(samples.cols()) * repeats;
    for (int i = 0; i < count; ++i)
      set(i, samples.col(i / repeats));
    pad(count);
  }
  // In the order of `deform_to_fit()`.
  Sample_lanes(const Points& samples, const std::vector<int>& order) : repeats(int(order.size() / samples.cols()))
  {
    const int count = int(order.size());
    if (repeats > 1 && order[0] / repeats != order[1] / repeats) stride = repeats; // columns of the grid became rows
    for (int i = 0; i < count; ++i)
      set(i, samples.col(repeats == 1 ? order[std::size_t(i)] : order[std::size_t(i)] / repeats));
    pad(count);
  }

private:
  template <typename Sample>
  void set(int i, const Sample& sample)
  {
    for (int axis = 0; axis < 3; ++axis)
      coordinates[axis][i] = float(sample[axis]);
  }
  void pad(int count)
  {
    for (auto& axis : coordinates)
      std::fill(axis + count, axis + lane_count, far_away);
  }
};

// The directions of rods from one sample to a block of samples; 0 where there is no rod.
struct alignas(64) Rod_block
{
  float direction[3][block_lanes];
};

// The layout of rods: in rows from the first samples to as many of the second as fill whole blocks, then in rows from
// the other second samples back to the first.
constexpr int samples_in_blocks(int count) { return count / block_lanes * block_lanes; }
constexpr int blocks_of(int count) { return (count + block_lanes - 1) / block_lanes; }

// Squared length, in units of the shape's height, under which a rod has no direction. After the deformation a rod
// counts as at least so long.
constexpr float zero_rod = 1e-9f;

} // namespace CGAL::Shape_correspondence::internal

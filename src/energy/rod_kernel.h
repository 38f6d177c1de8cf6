// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "structure/Sampled_part.h"

#include <algorithm>

// Eq. 2 (`rod_rotation()`) for all rods of a pair of parts at once: almost all of the search's time goes here. Numbers
// are in single precision, whose error of 1e-7 is far below what any comparison of energies sees, and in blocks of as
// many lanes as the widest vector has, so that all sets of instructions give the same bits.

namespace CGAL::Shape_correspondence::internal {

constexpr int maximum_samples = samples_per_side * samples_per_side; // of a part
constexpr int block_lanes = 16;                                      // floats of the widest vector
constexpr int maximum_blocks = (maximum_samples + block_lanes - 1) / block_lanes;
constexpr int lane_count = block_lanes * maximum_blocks;

// Coordinate of the padding lanes: finite, and far from all samples.
constexpr float far_away = 1e6f;

// Squared length, in units of the shape's height, below which a rod has no direction. After the deformation, a rod
// counts as at least this long.
constexpr float zero_rod = 1e-9f;

// Up to `maximum_samples` points, coordinate by coordinate, then padding.
struct alignas(64) Sample_lanes
{
  float coordinates[3][lane_count];

  explicit Sample_lanes(const Points& points)
  {
    for (int axis = 0; axis < 3; ++axis) {
      for (int i = 0; i < int(points.cols()); ++i)
        coordinates[axis][i] = float(points(axis, i));
      std::fill(coordinates[axis] + points.cols(), coordinates[axis] + lane_count, far_away);
    }
  }
};

// Unit directions of the rods from one sample to a block of samples; 0 where there is no rod, or one of length zero.
struct alignas(64) Rod_block
{
  float direction[3][block_lanes];
};

// The rods between n and m samples are stored as rows of blocks: for each of the n samples a row to those of the m that
// fill whole blocks, then for each of the others a row back to the n samples.
constexpr int samples_in_blocks(int count) { return count / block_lanes * block_lanes; }
constexpr int blocks_of(int count) { return (count + block_lanes - 1) / block_lanes; }
constexpr int blocks_of_rods(int n, int m)
{
  return n * blocks_of(samples_in_blocks(m)) + (m - samples_in_blocks(m)) * blocks_of(n);
}

struct Rod_lengths
{
  int zero = 0; // number of rods without a direction
  float shortest_squared, longest_squared;
};

// Writes the directions of the rods between n samples of one part and m of another.
Rod_lengths write_rods(const Sample_lanes& first, int n, const Sample_lanes& second, int m, Rod_block* rods);

// Rods after a deformation, compared with those of up to two pairs of parts before it.
struct Rod_comparison
{
  float squared_cosines[2] = {};  // sums over the rods that had a direction
  float least_squared_length = 0; // after the deformation, where it is asked for
};

// Without any pair before, the least length alone; with one, both; with one or two, the cosines alone.
using Compare_rods = Rod_comparison(const Rod_block* const* before, const Sample_lanes& first, int n,
                                    const Sample_lanes& second, int m);
Compare_rods least_length_of_rods, compare_rods_and_length, compare_rods_of_one, compare_rods_of_two;

} // namespace CGAL::Shape_correspondence::internal

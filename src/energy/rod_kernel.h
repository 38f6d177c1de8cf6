// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "structure/Sampled_part.h"

#include <algorithm>

// Eq. 2 (`rod_rotation()`) for all rods of a pair of parts at once, which takes almost all of the search's time.
// Numbers are in single precision, whose error of 1e-7 is below `comparison_grid`, and in blocks with as many lanes
// as the widest vector, so that all instruction sets give the same bits.

namespace CGAL::Shape_correspondence::internal {

constexpr int maximum_samples = samples_per_side * samples_per_side; // number of samples of a sheet; a curve has fewer
constexpr int block_lanes = 16;                                      // number of floats in the widest vector register
constexpr int maximum_blocks = (maximum_samples + block_lanes - 1) / block_lanes; // number of blocks of a sheet
constexpr int lane_count = block_lanes * maximum_blocks; // number of samples of a sheet with padding

// Coordinate of padding samples: finite, and far from all others.
constexpr float far_away = 1e6f;

// Squared length, over the squared height of the shape, below which a rod has no direction. After the deformation it is
// the lower bound of a rod's squared length.
constexpr float zero_rod = 1e-9f;

// Up to `maximum_samples` points as arrays of x, y and z, padded.
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

// Unit directions of the rods from one sample to a block of samples; 0 for padding and for rods of length zero.
struct alignas(64) Rod_block
{
  float direction[3][block_lanes];
};

// The rods between n and m samples are stored as rows of blocks: one row for each of the n samples, to those of the m
// samples that fill whole blocks, then one row for each remaining one of the m samples, to the n samples.
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

// The rods of a pair of parts after a deformation, compared with those of up to two pairs before it.
struct Rod_comparison
{
  float squared_cosines[2] = {};  // for each pair before: sum over its rods that have a direction
  float least_squared_length = 0; // least of all rods after the deformation; not set by all functions
};

// Comparisons with no pair before (least length only), one pair (with or without least length), or two pairs (cosines
// only).
using Compare_rods = Rod_comparison(const Rod_block* const* before, const Sample_lanes& first, int n,
                                    const Sample_lanes& second, int m);
Compare_rods least_length_of_rods, compare_rods_and_length, compare_rods_of_one, compare_rods_of_two;

} // namespace CGAL::Shape_correspondence::internal

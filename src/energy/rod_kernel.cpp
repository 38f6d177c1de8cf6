// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

// Compiled with -fno-rounding-math and -fno-math-errno, so that compilers vectorize comparisons and square roots.

#include "energy/rod_kernel.h"

#include "base/target_clones.h"

#include <cmath>

namespace CGAL::Shape_correspondence::internal {

namespace {

// By lane of a block: sums of squared cosines, for each of `Sources` pairs of parts, and least squared lengths.
template <int Sources>
struct Comparison_lanes
{
  float cosines[std::max(Sources, 1)][block_lanes] = {}, least[block_lanes];

  Comparison_lanes() { std::fill(std::begin(least), std::end(least), far_away * far_away); }
};

// Compares rows of `Blocks` blocks: row i holds the rods from sample i of `from`, `begin` <= i < `end`, to the first
// samples of `to`; its undeformed rods begin at block `at_block` of `before`. Two rows at a time share a division, the
// slowest operation. A rod that turned by more than a right angle counts 0 (Eq. 2).
template <int Blocks, int Sources, bool Least>
CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE void compare_rows(const Rod_block* const* before, int at_block,
                                                          const Sample_lanes& from, int begin, int end,
                                                          const Sample_lanes& to, Comparison_lanes<Sources>& totals)
{
  const auto& at = from.coordinates;
  for (int i = begin; i < end; i += 2) {
    const int next = std::min(i + 1, end - 1);
    const float x = at[0][i], y = at[1][i], z = at[2][i];
    const float next_x = at[0][next], next_y = at[1][next], next_z = at[2][next], is_pair = next > i ? 1 : 0;
#pragma GCC unroll 3
    for (int block = 0; block < Blocks; ++block) {
      const float *to_x = to.coordinates[0] + block * block_lanes, *to_y = to.coordinates[1] + block * block_lanes,
                  *to_z = to.coordinates[2] + block * block_lanes;
      const int row = at_block + (i - begin) * Blocks + block, next_row = row + (next - i) * Blocks;
      for (int k = 0; k < block_lanes; ++k) {
        const float a = to_x[k] - x, b = to_y[k] - y, c = to_z[k] - z;
        const float next_a = to_x[k] - next_x, next_b = to_y[k] - next_y, next_c = to_z[k] - next_z;
        float length = a * a + b * b + c * c, next_length = next_a * next_a + next_b * next_b + next_c * next_c;
        if constexpr (Least) {
          totals.least[k] = length < totals.least[k] ? length : totals.least[k];
          totals.least[k] = next_length < totals.least[k] ? next_length : totals.least[k];
        }
        if constexpr (Sources > 0) {
          length = length > zero_rod ? length : zero_rod;
          next_length = next_length > zero_rod ? next_length : zero_rod;
          const float inverse_of_both = 1 / (length * next_length), inverse = inverse_of_both * next_length,
                      next_inverse = is_pair * (inverse_of_both * length);
#pragma GCC unroll 2
          for (int s = 0; s < Sources; ++s) {
            const auto &rod = before[s][row].direction, &next_rod = before[s][next_row].direction;
            float along = rod[0][k] * a + rod[1][k] * b + rod[2][k] * c;
            float next_along = next_rod[0][k] * next_a + next_rod[1][k] * next_b + next_rod[2][k] * next_c;
            along = along > 0 ? along : 0;
            next_along = next_along > 0 ? next_along : 0;
            totals.cosines[s][k] += along * along * inverse + next_along * next_along * next_inverse;
          }
        }
      }
    }
  }
}

// Adds up the lanes pairwise, in the same order for every instruction set.
float sum_of_block(const float (&lanes)[block_lanes])
{
  float sums[block_lanes];
  std::copy_n(lanes, block_lanes, sums);
  for (int half = block_lanes / 2; half > 0; half /= 2)
    for (int k = 0; k < half; ++k)
      sums[k] += sums[k + half];
  return sums[0];
}

template <int Sources, bool Least>
CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE Rod_comparison compare(const Rod_block* const* before,
                                                               const Sample_lanes& first, int n,
                                                               const Sample_lanes& second, int m)
{
  static_assert(maximum_blocks == 3, "a case for every number of blocks");
  const int in_blocks = samples_in_blocks(m), blocks = blocks_of(in_blocks);
  Comparison_lanes<Sources> totals;
  if (blocks == 1) compare_rows<1, Sources, Least>(before, 0, first, 0, n, second, totals);
  if (blocks == 2) compare_rows<2, Sources, Least>(before, 0, first, 0, n, second, totals);
  const int back = in_blocks < m ? blocks_of(n) : 0;
  if (back == 1) compare_rows<1, Sources, Least>(before, n * blocks, second, in_blocks, m, first, totals);
  if (back == 2) compare_rows<2, Sources, Least>(before, n * blocks, second, in_blocks, m, first, totals);
  if (back == 3) compare_rows<3, Sources, Least>(before, n * blocks, second, in_blocks, m, first, totals);
  Rod_comparison result;
  for (int s = 0; s < Sources; ++s)
    result.squared_cosines[s] = sum_of_block(totals.cosines[s]);
  if (Least) result.least_squared_length = *std::min_element(std::begin(totals.least), std::end(totals.least));
  return result;
}

struct Length_lanes
{
  int zero[block_lanes] = {};
  float shortest_squared[block_lanes], longest_squared[block_lanes] = {};

  Length_lanes() { std::fill(std::begin(shortest_squared), std::end(shortest_squared), far_away * far_away); }
};

// Writes the rods from a point to a block of samples of `to`, the first `count` of which are no padding.
template <bool IsFull>
CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE void write_block(const float (&from)[3], const Sample_lanes& to, int first,
                                                         int count, Rod_block& rods, Length_lanes& totals)
{
  Rod_block row;
  for (int k = 0; k < block_lanes; ++k) {
    const bool is_rod = IsFull || k < count;
    const float x = to.coordinates[0][first + k] - from[0], y = to.coordinates[1][first + k] - from[1],
                z = to.coordinates[2][first + k] - from[2];
    const float squared = x * x + y * y + z * z, inverse = 1 / std::sqrt(squared);
    const float scale = squared < zero_rod || !is_rod ? 0 : inverse, of_rod = is_rod ? squared : 0;
    row.direction[0][k] = x * scale;
    row.direction[1][k] = y * scale;
    row.direction[2][k] = z * scale;
    totals.zero[k] += squared < zero_rod && is_rod ? 1 : 0;
    totals.shortest_squared[k] = squared < totals.shortest_squared[k] ? squared : totals.shortest_squared[k];
    totals.longest_squared[k] = of_rod > totals.longest_squared[k] ? of_rod : totals.longest_squared[k];
  }
  rods = row;
}

// Writes the rods from a point to the first `count` samples of `to`.
CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE void write_row(const float (&from)[3], const Sample_lanes& to, int count,
                                                       Rod_block* rods, Length_lanes& totals)
{
  const int full = samples_in_blocks(count);
  for (int first = 0; first < full; first += block_lanes)
    write_block<true>(from, to, first, block_lanes, *rods++, totals);
  if (full < count) write_block<false>(from, to, full, count - full, *rods, totals);
}

// Writes the rods from samples `begin` to `end` of `from` to `count` samples of `to`. \return the end of the blocks
CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE Rod_block* write_rows(const Sample_lanes& from, int begin, int end,
                                                              const Sample_lanes& to, int count, Rod_block* rods,
                                                              Length_lanes& totals)
{
  const auto& at = from.coordinates;
  for (int i = begin; i < end; ++i, rods += blocks_of(count))
    write_row({at[0][i], at[1][i], at[2][i]}, to, count, rods, totals);
  return rods;
}

} // namespace

CGAL_SHAPE_CORRESPONDENCE_CLONED
Rod_lengths write_rods(const Sample_lanes& first, int n, const Sample_lanes& second, int m, Rod_block* rods)
{
  Length_lanes totals;
  const int in_blocks = samples_in_blocks(m);
  rods = write_rows(first, 0, n, second, in_blocks, rods, totals);
  write_rows(second, in_blocks, m, first, n, rods, totals);
  Rod_lengths result{0, totals.shortest_squared[0], totals.longest_squared[0]};
  for (int k = 0; k < block_lanes; ++k) {
    result.zero += totals.zero[k];
    result.shortest_squared = std::min(result.shortest_squared, totals.shortest_squared[k]);
    result.longest_squared = std::max(result.longest_squared, totals.longest_squared[k]);
  }
  return result;
}

#define CGAL_SHAPE_CORRESPONDENCE_COMPARE(name, sources, least)                                                        \
  CGAL_SHAPE_CORRESPONDENCE_CLONED                                                                                     \
  Rod_comparison name(const Rod_block* const* before, const Sample_lanes& first, int n, const Sample_lanes& second,    \
                      int m)                                                                                           \
  {                                                                                                                    \
    return compare<sources, least>(before, first, n, second, m);                                                       \
  }
CGAL_SHAPE_CORRESPONDENCE_COMPARE(least_length_of_rods, 0, true)
CGAL_SHAPE_CORRESPONDENCE_COMPARE(compare_rods_and_length, 1, true)
CGAL_SHAPE_CORRESPONDENCE_COMPARE(compare_rods_of_one, 1, false)
CGAL_SHAPE_CORRESPONDENCE_COMPARE(compare_rods_of_two, 2, false)
#undef CGAL_SHAPE_CORRESPONDENCE_COMPARE

} // namespace CGAL::Shape_correspondence::internal

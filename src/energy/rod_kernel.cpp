// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

// Compiled without -frounding-math and errno, with which compilers use no vector instructions for comparisons and
// square roots.

#include "energy/rod_kernel.h"

#include "base/vector_functions.h"

#include <cmath>
#include <cstdint>
#include <cstring>

namespace CGAL::Shape_correspondence::internal {

namespace {

template <int Width>
using Lane_vector = typename Vector_of<float, Width>::type;

// x becomes max(x, y), or min(x, y), where not both are negative: compared as integers, which compilers know a maximum
// of. Vectors are passed by reference, since their calling convention depends on the instructions.
template <int Width, bool Greater, typename Lanes>
CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE void keep(Lanes& x, const Lanes& y)
{
  if constexpr (Width == 1) {
    x = (Greater ? y > x : y < x) ? y : x;
  } else {
    using Bits = typename Vector_of<std::int32_t, Width>::type;
    const Bits a = reinterpret_cast<Bits>(x), b = reinterpret_cast<Bits>(y);
    x = reinterpret_cast<Lanes>((Greater ? b > a : b < a) ? b : a);
  }
}

// A vector of lanes in memory.
template <int Width>
CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE const Lane_vector<Width>& lanes_at(const float* lanes, int index)
{
  return *reinterpret_cast<const Lane_vector<Width>*>(lanes + std::ptrdiff_t(index) * Width);
}

// The rods from a point to a vector of samples, and their squared lengths.
template <int Width, typename Lanes>
CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE void find_rods(const float (&from)[3], const Sample_lanes& to, int index,
                                                       Lanes (&rod)[3], Lanes& squared_length)
{
  for (int axis = 0; axis < 3; ++axis)
    rod[axis] = lanes_at<Width>(to.coordinates[axis], index) - from[axis];
  squared_length = rod[0] * rod[0] + rod[1] * rod[1] + rod[2] * rod[2];
}

// The squared lengths of rods along their directions before; 0 beyond a right angle (Eq. 2).
template <int Width, typename Lanes>
CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE void find_squared_along(const Rod_block& before, int in_block,
                                                                const Lanes (&rod)[3], Lanes& squared)
{
  Lanes along = lanes_at<Width>(before.direction[0], in_block) * rod[0] +
                lanes_at<Width>(before.direction[1], in_block) * rod[1] +
                lanes_at<Width>(before.direction[2], in_block) * rod[2];
  keep<Width, true>(along, Lanes{});
  squared = along * along;
}

// A comparison up to a block of lanes.
template <int Width, int Sources>
struct Comparison_lanes
{
  using Lanes = Lane_vector<Width>;
  static constexpr int in_block = block_lanes / Width;

  Lanes cosines[std::max(Sources, 1)][in_block] = {}, least[in_block];

  Comparison_lanes()
  {
    for (Lanes& lanes : least)
      lanes = Lanes{} + far_away * far_away;
  }
};

// Compares rows of `Blocks` blocks: row i has the rods from sample i of `from`, between `begin` and `end`, to the first
// samples of `to`; those before are `at_block` blocks behind `before`. Two rows at a time share a division, the slowest
// of the operations.
template <int Width, int Blocks, int Sources, bool Least>
CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE void
compare_rows(const Rod_block* const* before, int at_block, const Sample_lanes& from, int begin, int end,
             const Sample_lanes& to, Comparison_lanes<Width, Sources>& totals)
{
  using Lanes = Lane_vector<Width>;
  constexpr int in_block = block_lanes / Width;
  const Lanes least_length = Lanes{} + zero_rod;
  const auto& at = from.coordinates;
  for (int i = begin; i < end; i += 2) {
    const bool is_pair = i + 1 < end;
    const int next = is_pair ? i + 1 : i;
    const float start[3] = {at[0][i], at[1][i], at[2][i]}, next_start[3] = {at[0][next], at[1][next], at[2][next]};
    const int row = at_block + (i - begin) * Blocks, next_row = at_block + (next - begin) * Blocks;
#pragma GCC unroll 12
    for (int l = 0; l < Blocks * in_block; ++l) {
      const int block = l / in_block, k = l % in_block;
      Lanes rod[3], next_rod[3], length, next_length;
      find_rods<Width>(start, to, l, rod, length);
      find_rods<Width>(next_start, to, l, next_rod, next_length);
      if constexpr (Least) {
        keep<Width, false>(totals.least[k], length);
        keep<Width, false>(totals.least[k], next_length);
      }
      if constexpr (Sources > 0) {
        keep<Width, true>(length, least_length);
        keep<Width, true>(next_length, least_length);
        const Lanes both = 1.0f / (length * next_length), inverse = both * next_length,
                    next_inverse = is_pair ? both * length : Lanes{};
#pragma GCC unroll 4
        for (int s = 0; s < Sources; ++s) {
          Lanes squared, next_squared;
          find_squared_along<Width>(before[s][row + block], k, rod, squared);
          find_squared_along<Width>(before[s][next_row + block], k, next_rod, next_squared);
          totals.cosines[s][k] += squared * inverse + next_squared * next_inverse;
        }
      }
    }
  }
}

// The same for all n samples of `from`, of which several are equal: their rods after the deformation are found once.
template <int Width, int Blocks, int Sources, bool Least>
CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE void compare_equal_rows(const Rod_block* const* before,
                                                                const Sample_lanes& from, int n, const Sample_lanes& to,
                                                                Comparison_lanes<Width, Sources>& totals)
{
  using Lanes = Lane_vector<Width>;
  constexpr int in_block = block_lanes / Width;
  const Lanes least_length = Lanes{} + zero_rod;
  const auto& at = from.coordinates;
  const int repeats = from.repeats, stride = from.stride;
  for (int group = 0; group < n / repeats; ++group) {
    const int first = stride == 1 ? group * repeats : group;
    const float start[3] = {at[0][first], at[1][first], at[2][first]};
    for (int l = 0; l < Blocks * in_block; ++l) {
      const int block = l / in_block, k = l % in_block;
      Lanes rod[3], length;
      find_rods<Width>(start, to, l, rod, length);
      if constexpr (Least) keep<Width, false>(totals.least[k], length);
      if constexpr (Sources > 0) {
        keep<Width, true>(length, least_length);
        const Lanes inverse = 1.0f / length;
#pragma GCC unroll 4
        for (int s = 0; s < Sources; ++s) {
          const Rod_block* rods = before[s] + std::ptrdiff_t(first) * Blocks + block;
          Lanes sum = {};
          for (int i = 0; i < repeats; ++i, rods += std::ptrdiff_t(stride) * Blocks) {
            Lanes squared;
            find_squared_along<Width>(*rods, k, rod, squared);
            sum += squared;
          }
          totals.cosines[s][k] += sum * inverse;
        }
      }
    }
  }
}

// Halves are added up, in the same order for every width.
template <int Width>
CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE float sum_of_block(const float* lanes)
{
  static_assert(block_lanes == 16, "halved four times");
  constexpr int eight = Width == 1 ? 1 : 8, four = Width == 1 ? 1 : 4;
  alignas(64) float halves[8], quarters[4];
  for (int i = 0; i < 8 / eight; ++i) {
    const auto sum = lanes_at<eight>(lanes, i) + lanes_at<eight>(lanes + 8, i);
    std::memcpy(halves + std::ptrdiff_t(i) * eight, &sum, sizeof sum);
  }
  for (int i = 0; i < 4 / four; ++i) {
    const auto sum = lanes_at<four>(halves, i) + lanes_at<four>(halves + 4, i);
    std::memcpy(quarters + std::ptrdiff_t(i) * four, &sum, sizeof sum);
  }
  return (quarters[0] + quarters[2]) + (quarters[1] + quarters[3]);
}

template <int Width, int Sources, bool Least>
CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE Rod_comparison compare(const Rod_block* const* before,
                                                               const Sample_lanes& first, int n,
                                                               const Sample_lanes& second, int m)
{
  static_assert(maximum_blocks == 3, "a case for every number of blocks");
  const int in_blocks = samples_in_blocks(m), blocks = blocks_of(in_blocks), back_blocks = blocks_of(n);
  const int back = n * blocks;
  Comparison_lanes<Width, Sources> totals;
  if (blocks == 1) compare_rows<Width, 1, Sources, Least>(before, 0, first, 0, n, second, totals);
  if (blocks == 2 && first.repeats > 1)
    compare_equal_rows<Width, 2, Sources, Least>(before, first, n, second, totals);
  else if (blocks == 2)
    compare_rows<Width, 2, Sources, Least>(before, 0, first, 0, n, second, totals);
  if (in_blocks < m) {
    if (back_blocks == 1) compare_rows<Width, 1, Sources, Least>(before, back, second, in_blocks, m, first, totals);
    if (back_blocks == 2) compare_rows<Width, 2, Sources, Least>(before, back, second, in_blocks, m, first, totals);
    if (back_blocks == 3) compare_rows<Width, 3, Sources, Least>(before, back, second, in_blocks, m, first, totals);
  }
  Rod_comparison result;
  alignas(64) float lanes[block_lanes];
  if constexpr (Sources > 0)
    for (int s = 0; s < Sources; ++s) {
      std::memcpy(lanes, totals.cosines[s], sizeof lanes);
      result.squared_cosines[s] = sum_of_block<Width>(lanes);
    }
  if (Least) {
    std::memcpy(lanes, totals.least, sizeof lanes);
    result.least_squared_length = *std::min_element(lanes, lanes + block_lanes);
  }
  return result;
}

struct Length_lanes
{
  int zero[block_lanes] = {};
  float shortest_squared[block_lanes], longest_squared[block_lanes] = {};

  Length_lanes() { std::fill(std::begin(shortest_squared), std::end(shortest_squared), far_away * far_away); }
};

// The row of rods from a point to the first `count` samples of `to`, which stands for `repeats` equal ones. Compilers
// use vector instructions here.
CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE void write_row(const float (&from)[3], int repeats, const Sample_lanes& to,
                                                       int count, Rod_block* rods, Length_lanes& totals)
{
  for (int block = 0; block < blocks_of(count); ++block) {
    Rod_block row;
    for (int k = 0; k < block_lanes; ++k) {
      const int i = block * block_lanes + k;
      const float x = to.coordinates[0][i] - from[0], y = to.coordinates[1][i] - from[1],
                  z = to.coordinates[2][i] - from[2];
      const float squared = x * x + y * y + z * z, inverse = 1.0f / std::sqrt(squared);
      const float scale = squared < zero_rod || i >= count ? 0 : inverse, of_rod = i < count ? squared : 0;
      row.direction[0][k] = x * scale;
      row.direction[1][k] = y * scale;
      row.direction[2][k] = z * scale;
      totals.zero[k] += squared < zero_rod && i < count ? repeats : 0;
      totals.shortest_squared[k] = squared < totals.shortest_squared[k] ? squared : totals.shortest_squared[k];
      totals.longest_squared[k] = of_rod > totals.longest_squared[k] ? of_rod : totals.longest_squared[k];
    }
    rods[block] = row;
  }
}

// The rows from the samples `begin` to `end`.
CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE Rod_block* write_rows(const Sample_lanes& from, int begin, int end,
                                                              const Sample_lanes& to, int count, Rod_block* rods,
                                                              Length_lanes& totals)
{
  const auto& at = from.coordinates;
  const int blocks = blocks_of(count);
  for (int i = begin; i < end;) {
    const int equal = std::min(end, (i / from.repeats + 1) * from.repeats) - i;
    write_row({at[0][i], at[1][i], at[2][i]}, equal, to, count, rods, totals);
    for (int copy = 1; copy < equal; ++copy)
      std::copy_n(rods, blocks, rods + std::ptrdiff_t(copy) * blocks);
    rods += std::ptrdiff_t(equal) * blocks;
    i += equal;
  }
  return rods;
}

CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE Rod_lengths write(const Sample_lanes& first, int n, const Sample_lanes& second,
                                                          int m, Rod_block* rods)
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

#define CGAL_SHAPE_CORRESPONDENCE_COMPARE(name, instructions, bytes, sources, least)                                   \
  CGAL_SHAPE_CORRESPONDENCE_TARGET(instructions)                                                                       \
  Rod_comparison name(const Rod_block* const* before, const Sample_lanes& first, int n, const Sample_lanes& second,    \
                      int m)                                                                                           \
  {                                                                                                                    \
    return compare<vector_width<float>(bytes), sources, least>(before, first, n, second, m);                           \
  }
#define CGAL_SHAPE_CORRESPONDENCE_ROD_KERNEL(name, instructions, bytes)                                                \
  CGAL_SHAPE_CORRESPONDENCE_TARGET(instructions)                                                                       \
  Rod_lengths write_##name(const Sample_lanes& first, int n, const Sample_lanes& second, int m, Rod_block* rods)       \
  {                                                                                                                    \
    return write(first, n, second, m, rods);                                                                           \
  }                                                                                                                    \
  CGAL_SHAPE_CORRESPONDENCE_COMPARE(least_length_##name, instructions, bytes, 0, true)                                 \
  CGAL_SHAPE_CORRESPONDENCE_COMPARE(one_and_length_##name, instructions, bytes, 1, true)                               \
  CGAL_SHAPE_CORRESPONDENCE_COMPARE(one_##name, instructions, bytes, 1, false)                                         \
  CGAL_SHAPE_CORRESPONDENCE_COMPARE(two_##name, instructions, bytes, 2, false)                                         \
  CGAL_SHAPE_CORRESPONDENCE_COMPARE(four_##name, instructions, bytes, 4, false)                                        \
  constexpr Rod_kernel rod_kernel_##name{#name,      write_##name, least_length_##name, one_and_length_##name,         \
                                         one_##name, two_##name,   four_##name};
CGAL_SHAPE_CORRESPONDENCE_FOR_INSTRUCTIONS(CGAL_SHAPE_CORRESPONDENCE_ROD_KERNEL)
#undef CGAL_SHAPE_CORRESPONDENCE_ROD_KERNEL
#undef CGAL_SHAPE_CORRESPONDENCE_COMPARE

} // namespace

std::vector<Rod_kernel> available_rod_kernels()
{
  return runnable<Rod_kernel>(CGAL_SHAPE_CORRESPONDENCE_VERSIONS(rod_kernel_));
}

const Rod_kernel& rod_kernel()
{
  static const Rod_kernel fastest = available_rod_kernels().back();
  return fastest;
}

} // namespace CGAL::Shape_correspondence::internal

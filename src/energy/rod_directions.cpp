// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

// Compiled without -frounding-math, which CGAL's number types need, and errno of square roots: with either of them,
// compilers use no vector instructions here.

#include "energy/rod_directions.h"

#include "base/vector_functions.h"
#include "energy/rod_cosines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <numeric>

namespace CGAL::Shape_correspondence::internal {

namespace {

constexpr std::array<std::int32_t, lane_count> numbers_of_lanes()
{
  std::array<std::int32_t, lane_count> result{};
  for (int i = 0; i < lane_count; ++i)
    result[std::size_t(i)] = i;
  return result;
}
alignas(64) constexpr std::array<std::int32_t, lane_count> lane_indices = numbers_of_lanes();

// What rows have in common so far, lane by lane. Positive numbers compare as their bits do.
template <int Width>
struct Row_totals
{
  using Lanes = typename Lane_vector<Width>::type;
  using Bits = typename Lane_vector<Width>::bits;

  Bits directionless = {}, longest_squared = {}, shortest_squared;

  Row_totals()
  {
    const Lanes longer = Lanes{} + far_away * far_away;
    std::memcpy(&shortest_squared, &longer, sizeof longer);
  }

  Rod_rows result() const
  {
    std::int32_t counts[Width];
    float longest[Width], shortest[Width];
    std::memcpy(counts, &directionless, sizeof counts);
    std::memcpy(longest, &longest_squared, sizeof longest);
    std::memcpy(shortest, &shortest_squared, sizeof shortest);
    return {std::accumulate(counts, counts + Width, 0), *std::min_element(shortest, shortest + Width),
            *std::max_element(longest, longest + Width)};
  }
};

template <int Width>
CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE void find_roots(const typename Lane_vector<Width>::type& squares,
                                                        typename Lane_vector<Width>::type& roots)
{
  if constexpr (Width == 1)
    roots = std::sqrt(squares);
  else
    for (int i = 0; i < Width; ++i) // one instruction
      roots[i] = std::sqrt(squares[i]);
}

// A row of rods from a sample of `from` to the first `count` samples of `to`, which stands for `repeats` equal ones. By
// hand, since compilers use no vector instructions for what depends on comparisons. Those are signs of differences
// here: all bits of a lane, or none.
template <int Width>
CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE void write_row(const Sample_lanes& from, int sample, int repeats,
                                                       const Sample_lanes& to, int count, Rod_block* rods,
                                                       Row_totals<Width>& totals)
{
#ifdef __clang__
#pragma STDC FP_CONTRACT OFF
#endif
  using Lanes = typename Lane_vector<Width>::type;
  using Bits = typename Lane_vector<Width>::bits;
  constexpr int in_block = block_lanes / Width, sign = 31;
  std::int32_t zero_bits;
  std::memcpy(&zero_bits, &zero_rod, sizeof zero_bits);
  const float start[3] = {from.coordinates[0][sample], from.coordinates[1][sample], from.coordinates[2][sample]};
  for (int l = 0; l < blocks_of(count) * in_block; ++l) {
    Lanes rod[3], squared, length;
    find_rods<Width>(start, to, l, rod, squared);
    find_roots<Width>(squared, length);
    const Lanes inverse = 1.0f / length;
    Bits index, squared_bits, scale_bits;
    std::memcpy(&index, lane_indices.data() + std::ptrdiff_t(l) * Width, sizeof index);
    std::memcpy(&squared_bits, &squared, sizeof squared_bits);
    std::memcpy(&scale_bits, &inverse, sizeof scale_bits);
    const Bits is_rod = (index - count) >> sign, has_direction = (zero_bits - 1 - squared_bits) >> sign;
    scale_bits &= is_rod & has_direction;
    Lanes scale;
    std::memcpy(&scale, &scale_bits, sizeof scale);
    for (int axis = 0; axis < 3; ++axis) {
      const Lanes direction = rod[axis] * scale;
      std::memcpy(rods[l / in_block].direction[axis] + std::ptrdiff_t(l % in_block) * Width, &direction,
                  sizeof direction);
    }
    const Bits of_rods = squared_bits & is_rod;
    totals.directionless += is_rod & ~has_direction & repeats;
    totals.shortest_squared = squared_bits < totals.shortest_squared ? squared_bits : totals.shortest_squared;
    totals.longest_squared = of_rods > totals.longest_squared ? of_rods : totals.longest_squared;
  }
}

template <int Width>
CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE Rod_rows rows(const Sample_lanes& from, int first, int last,
                                                      const Sample_lanes& to, int count, Rod_block* rods)
{
  const int blocks = blocks_of(count), repeats = from.repeats;
  Row_totals<Width> totals;
  while (first < last) {
    const int next = std::min(last, (first / repeats + 1) * repeats);
    const Rod_block* const row = rods;
    write_row(from, first, next - first, to, count, rods, totals);
    for (rods += blocks; ++first < next; rods += blocks)
      std::copy_n(row, blocks, rods);
  }
  return totals.result();
}

#define CGAL_SHAPE_CORRESPONDENCE_ROWS(name, instructions, bytes)                                                      \
  CGAL_SHAPE_CORRESPONDENCE_TARGET(instructions)                                                                       \
  Rod_rows rows_##name(const Sample_lanes& from, int first, int last, const Sample_lanes& to, int count,               \
                       Rod_block* rods)                                                                                \
  {                                                                                                                    \
    return rows<vector_width<float>(bytes)>(from, first, last, to, count, rods);                                       \
  }
CGAL_SHAPE_CORRESPONDENCE_FOR_INSTRUCTIONS(CGAL_SHAPE_CORRESPONDENCE_ROWS)
#undef CGAL_SHAPE_CORRESPONDENCE_ROWS

} // namespace

std::vector<Rod_writer> available_rod_writers()
{
  return runnable<Rod_writer>(CGAL_SHAPE_CORRESPONDENCE_VERSIONS(rows_));
}

} // namespace CGAL::Shape_correspondence::internal

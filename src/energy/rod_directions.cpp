// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

// Compiled without -frounding-math, which CGAL's number types need, and errno of square roots: with either of them,
// compilers use no vector instructions here.

#include "energy/rod_directions.h"

#include "base/vector_functions.h"
#include "energy/rod_cosines.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace CGAL::Shape_correspondence::internal {

namespace {

// What rows have in common so far, lane by lane. Compilers take no sums and maxima of loops by vector instructions, so
// that these are vectors, where there are any.
struct Row_totals
{
#ifdef __GNUC__
  using Lanes = Lane_vector<block_lanes>::bits;

  Lanes directionless = {}, longest_squared = {}; // the latter's bits, which compare as the numbers do

  CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE void add(const float (&squared)[block_lanes], int repeats)
  {
    Lanes bits;
    std::memcpy(&bits, squared, sizeof bits);
    std::int32_t zero_bits;
    std::memcpy(&zero_bits, &zero_rod, sizeof zero_bits);
    directionless -= (bits < zero_bits) * repeats; // true is -1
    longest_squared = bits > longest_squared ? bits : longest_squared;
  }

  CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE Rod_rows result() const
  {
    int sum = 0;
    std::int32_t longest = 0;
    for (int i = 0; i < block_lanes; ++i) {
      sum += directionless[i];
      longest = std::max(longest, longest_squared[i]);
    }
    Rod_rows rows{sum, 0};
    std::memcpy(&rows.longest_squared, &longest, sizeof longest);
    return rows;
  }
#else
  Rod_rows rows;

  void add(const float (&squared)[block_lanes], int repeats)
  {
    for (float square : squared) {
      rows.directionless += square < zero_rod ? repeats : 0;
      rows.longest_squared = std::max(rows.longest_squared, square);
    }
  }
  Rod_rows result() const { return rows; }
#endif
};

// A row of rods from a sample of `from` to the first `count` samples of `to`, which stands for `repeats` equal ones.
CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE void write_row(const Sample_lanes& from, int sample, int repeats,
                                                       const Sample_lanes& to, int count, Rod_block* rods,
                                                       Row_totals& totals)
{
#ifdef __clang__
#pragma STDC FP_CONTRACT OFF
#endif
  const float x = from.coordinates[0][sample], y = from.coordinates[1][sample], z = from.coordinates[2][sample];
  for (int begin = 0; begin < count; begin += block_lanes, ++rods) {
    alignas(64) float squared[block_lanes];
    for (int i = 0; i < block_lanes; ++i) {
      const float dx = to.coordinates[0][begin + i] - x, dy = to.coordinates[1][begin + i] - y,
                  dz = to.coordinates[2][begin + i] - z;
      squared[i] = dx * dx + dy * dy + dz * dz;
      const float scale = squared[i] < zero_rod ? 0.f : 1 / std::sqrt(std::max(squared[i], zero_rod));
      rods->direction[0][i] = dx * scale;
      rods->direction[1][i] = dy * scale;
      rods->direction[2][i] = dz * scale;
    }
    const int used = count - begin;
    if (used < block_lanes) { // behind them are no rods
      for (auto& axis : rods->direction)
        std::fill(axis + used, axis + block_lanes, 0.f);
      std::fill(squared + used, squared + block_lanes, zero_rod);
    }
    totals.add(squared, repeats);
  }
}

CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE Rod_rows rows(const Sample_lanes& from, int first, int last, int repeats,
                                                      const Sample_lanes& to, int count, Rod_block* rods)
{
  const int blocks = blocks_of(count);
  Row_totals totals;
  while (first < last) {
    const int next = std::min(last, (first / repeats + 1) * repeats);
    const Rod_block* const row = rods;
    write_row(from, first, next - first, to, count, rods, totals);
    for (rods += blocks; ++first < next; rods += blocks)
      std::copy_n(row, blocks, rods);
  }
  return totals.result();
}

using Rows = Rod_rows (*)(const Sample_lanes&, int, int, int, const Sample_lanes&, int, Rod_block*);

#define CGAL_SHAPE_CORRESPONDENCE_ROWS(name, instructions)                                                             \
  CGAL_SHAPE_CORRESPONDENCE_TARGET(instructions)                                                                       \
  Rod_rows name(const Sample_lanes& from, int first, int last, int repeats, const Sample_lanes& to, int count,         \
                Rod_block* rods)                                                                                       \
  {                                                                                                                    \
    return rows(from, first, last, repeats, to, count, rods);                                                          \
  }
CGAL_SHAPE_CORRESPONDENCE_ROWS(rows_sse2, "sse2")
#ifdef CGAL_SHAPE_CORRESPONDENCE_X86
CGAL_SHAPE_CORRESPONDENCE_ROWS(rows_avx2, "avx2")
CGAL_SHAPE_CORRESPONDENCE_ROWS(rows_avx512, "avx512f")
#endif
#undef CGAL_SHAPE_CORRESPONDENCE_ROWS

Rows fastest_rows()
{
#ifdef CGAL_SHAPE_CORRESPONDENCE_X86
  if (__builtin_cpu_supports("avx512f")) return rows_avx512;
  if (__builtin_cpu_supports("avx2")) return rows_avx2;
#endif
  return rows_sse2;
}

} // namespace

Rod_rows write_rod_directions(const Sample_lanes& from, int first, int last, int repeats, const Sample_lanes& to,
                              int count, Rod_block* rods)
{
  static const Rows fastest = fastest_rows();
  return fastest(from, first, last, repeats, to, count, rods);
}

} // namespace CGAL::Shape_correspondence::internal

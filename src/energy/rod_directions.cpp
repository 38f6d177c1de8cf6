// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

// Compiled without -frounding-math, which CGAL's number types need, and errno of square roots: with either of them,
// compilers use no vector instructions here.

#include "energy/rod_directions.h"

#include "base/vector_functions.h"

#include <algorithm>
#include <cmath>

namespace CGAL::Shape_correspondence::internal {

namespace {

CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE Rod_row row(const Sample_lanes& from, int sample, const Sample_lanes& to,
                                                    int count, Rod_block* rods)
{
  const float x = from.coordinates[0][sample], y = from.coordinates[1][sample], z = from.coordinates[2][sample];
  Rod_row result;
  for (int begin = 0; begin < count; begin += block_lanes, ++rods) {
    float squared[block_lanes];
    for (int i = 0; i < block_lanes; ++i) {
      const float dx = to.coordinates[0][begin + i] - x, dy = to.coordinates[1][begin + i] - y,
                  dz = to.coordinates[2][begin + i] - z;
      squared[i] = dx * dx + dy * dy + dz * dz;
      const float scale = squared[i] < zero_rod ? 0.f : 1 / std::sqrt(std::max(squared[i], zero_rod));
      rods->direction[0][i] = dx * scale;
      rods->direction[1][i] = dy * scale;
      rods->direction[2][i] = dz * scale;
    }
    const int used = std::min(block_lanes, count - begin);
    for (int i = 0; i < used; ++i) {
      result.directionless += squared[i] < zero_rod;
      result.longest_squared = std::max(result.longest_squared, squared[i]);
    }
    for (auto& axis : rods->direction)
      std::fill(axis + used, axis + block_lanes, 0.f); // no rods
  }
  return result;
}

using Row = Rod_row (*)(const Sample_lanes&, int, const Sample_lanes&, int, Rod_block*);

#define CGAL_SHAPE_CORRESPONDENCE_ROW(name, instructions)                                                              \
  CGAL_SHAPE_CORRESPONDENCE_TARGET(instructions)                                                                       \
  Rod_row name(const Sample_lanes& from, int sample, const Sample_lanes& to, int count, Rod_block* rods)               \
  {                                                                                                                    \
    return row(from, sample, to, count, rods);                                                                         \
  }
CGAL_SHAPE_CORRESPONDENCE_ROW(row_sse2, "sse2")
#ifdef CGAL_SHAPE_CORRESPONDENCE_X86
CGAL_SHAPE_CORRESPONDENCE_ROW(row_avx2, "avx2")
CGAL_SHAPE_CORRESPONDENCE_ROW(row_avx512, "avx512f")
#endif
#undef CGAL_SHAPE_CORRESPONDENCE_ROW

Row fastest_row()
{
#ifdef CGAL_SHAPE_CORRESPONDENCE_X86
  if (__builtin_cpu_supports("avx512f")) return row_avx512;
  if (__builtin_cpu_supports("avx2")) return row_avx2;
#endif
  return row_sse2;
}

} // namespace

Rod_row write_rod_directions(const Sample_lanes& from, int sample, const Sample_lanes& to, int count, Rod_block* rods)
{
  static const Row fastest = fastest_row();
  return fastest(from, sample, to, count, rods);
}

} // namespace CGAL::Shape_correspondence::internal

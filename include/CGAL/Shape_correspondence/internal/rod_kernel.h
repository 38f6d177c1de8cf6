// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_INTERNAL_ROD_KERNEL_H
#define CGAL_SHAPE_CORRESPONDENCE_INTERNAL_ROD_KERNEL_H

#include <CGAL/Shape_correspondence/Points.h>
#include <CGAL/Shape_correspondence/internal/vector_functions.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

// Almost all of the search's time goes here. Rods are in single precision, whose error of 1e-7 is far below what any
// comparison sees, and in lanes, each with a sum of its own: the widest vector instructions of the machine give the
// same bits as the narrowest. Contraction to fused operations would not.

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

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

  Sample_lanes() = default;
  explicit Sample_lanes(const Points& samples)
  {
    for (int axis = 0; axis < 3; ++axis)
      for (int i = 0; i < lane_count; ++i)
        coordinates[axis][i] = i < samples.cols() ? float(samples(axis, i)) : far_away;
  }
};

// The directions of rods from one sample to a block of samples; 0 where there is no rod.
struct alignas(64) Rod_block
{
  float direction[3][block_lanes];
};

// Squared length, in units of the shape's height, under which a rod has no direction. Added to squared lengths, it
// keeps them from being 0.
constexpr float zero_rod = 1e-9f;

template <int Width>
struct Lane_vector
{
#ifdef __GNUC__
  typedef float type __attribute__((vector_size(Width * sizeof(float)), may_alias));
  typedef std::int32_t bits __attribute__((vector_size(Width * sizeof(float))));
#else
  static_assert(Width == 1, "vector types need GCC or Clang");
#endif
};

template <>
struct Lane_vector<1>
{
  using type = float;
};

// x becomes max(x, 0). As integers, positive numbers compare the same, and the compiler knows a maximum when it sees
// one.
template <int Width>
CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE void keep_positive(typename Lane_vector<Width>::type& x)
{
  if constexpr (Width == 1) {
    x = x > 0 ? x : 0;
  } else {
    using Bits = typename Lane_vector<Width>::bits;
    const Bits zero = {}, bits = reinterpret_cast<Bits>(x);
    x = reinterpret_cast<typename Lane_vector<Width>::type>(bits > zero ? bits : zero);
  }
}

// x becomes min(x, y), where neither is negative.
template <int Width>
CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE void keep_least(typename Lane_vector<Width>::type& x,
                                                        const typename Lane_vector<Width>::type& y)
{
  if constexpr (Width == 1) {
    x = y < x ? y : x;
  } else {
    using Bits = typename Lane_vector<Width>::bits;
    const Bits a = reinterpret_cast<Bits>(x), b = reinterpret_cast<Bits>(y);
    x = reinterpret_cast<typename Lane_vector<Width>::type>(b < a ? b : a);
  }
}

// A block of lanes in memory. A copy by memcpy() would go through the stack in narrower pieces.
template <int Width>
CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE const typename Lane_vector<Width>::type& lanes_at(const float* lanes, int block)
{
  return *reinterpret_cast<const typename Lane_vector<Width>::type*>(lanes + block * Width);
}

// What is asked about rods: how far they keep their directions, how short the shortest is, or both.
enum class Rod_query { SQUARED_COSINES, LEAST_LENGTH, BOTH };

struct Rod_answer
{
  float squared_cosines;      // sum over all rods that have a direction, 0 beyond a right angle
  float least_squared_length; // of any two samples
};

// An answer up to a block of lanes. What was not asked stays as it is.
template <int Width>
struct Rod_totals
{
  using Lanes = typename Lane_vector<Width>::type;
  static constexpr int count = block_lanes / Width;

  Lanes cosines[count] = {}, least[count];

  Rod_totals()
  {
    for (Lanes& lanes : least)
      lanes = Lanes{} + far_away * far_away;
  }
};

// For a vector of lanes of a block: the squared cosine between before and after as a fraction, and the squared length.
template <int Width, Rod_query Query, typename Lanes>
CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE void compare_rods(const Rod_block* before, int in_block, const float (&from)[3],
                                                          const Sample_lanes& to, int lanes, Lanes& numerator,
                                                          Lanes& denominator, Lanes& squared_length)
{
#ifdef __clang__
#pragma STDC FP_CONTRACT OFF
#endif
  const Lanes x = lanes_at<Width>(to.coordinates[0], lanes) - from[0],
              y = lanes_at<Width>(to.coordinates[1], lanes) - from[1],
              z = lanes_at<Width>(to.coordinates[2], lanes) - from[2];
  squared_length = x * x + y * y + z * z;
  if constexpr (Query != Rod_query::LEAST_LENGTH) {
    Lanes product = lanes_at<Width>(before->direction[0], in_block) * x +
                    lanes_at<Width>(before->direction[1], in_block) * y +
                    lanes_at<Width>(before->direction[2], in_block) * z;
    keep_positive<Width>(product);
    numerator = product * product;
    denominator = squared_length + zero_rod;
  }
}

// Rods in rows of `Blocks` blocks: those of row i go from sample i of `from`, between `begin` and `end`, to the first
// samples of `to`. Rows are taken in pairs, whose fractions share a division, the slowest of the operations.
template <int Width, int Blocks, Rod_query Query>
CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE void add_rows(const Rod_block* rods, const Sample_lanes& from, int begin,
                                                      int end, const Sample_lanes& to, Rod_totals<Width>& totals)
{
#ifdef __clang__
#pragma STDC FP_CONTRACT OFF
#endif
  using Lanes = typename Lane_vector<Width>::type;
  constexpr int in_block = block_lanes / Width, count = Blocks * in_block;
  constexpr bool cosines = Query != Rod_query::LEAST_LENGTH, least = Query != Rod_query::SQUARED_COSINES;
  Lanes sums[count] = {}, numerator, denominator, length, other_numerator, other_denominator, other_length;
  const auto& at = from.coordinates;
  int i = begin;
  for (; i + 1 < end; i += 2) {
    const float start[3] = {at[0][i], at[1][i], at[2][i]};
    const float other_start[3] = {at[0][i + 1], at[1][i + 1], at[2][i + 1]};
#pragma GCC unroll 12
    for (int l = 0; l < count; ++l) {
      const int k = l % in_block;
      const Rod_block* block = cosines ? rods + (i - begin) * Blocks + l / in_block : nullptr;
      const Rod_block* other = cosines ? block + Blocks : nullptr;
      compare_rods<Width, Query>(block, k, start, to, l, numerator, denominator, length);
      compare_rods<Width, Query>(other, k, other_start, to, l, other_numerator, other_denominator, other_length);
      if constexpr (cosines)
        sums[l] += (numerator * other_denominator + other_numerator * denominator) / (denominator * other_denominator);
      if constexpr (least) {
        keep_least<Width>(length, other_length);
        keep_least<Width>(totals.least[k], length);
      }
    }
  }
  if (i < end) {
    const float start[3] = {at[0][i], at[1][i], at[2][i]};
#pragma GCC unroll 12
    for (int l = 0; l < count; ++l) {
      const Rod_block* block = cosines ? rods + (i - begin) * Blocks + l / in_block : nullptr;
      compare_rods<Width, Query>(block, l % in_block, start, to, l, numerator, denominator, length);
      if constexpr (cosines) sums[l] += numerator / denominator;
      if constexpr (least) keep_least<Width>(totals.least[l % in_block], length);
    }
  }
#pragma GCC unroll 12
  for (int l = 0; l < count; ++l)
    totals.cosines[l % in_block] += sums[l];
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
    std::memcpy(halves + i * eight, &sum, sizeof sum);
  }
  for (int i = 0; i < 4 / four; ++i) {
    const auto sum = lanes_at<four>(halves, i) + lanes_at<four>(halves + 4, i);
    std::memcpy(quarters + i * four, &sum, sizeof sum);
  }
  return (quarters[0] + quarters[2]) + (quarters[1] + quarters[3]);
}

// The layout of rods: in rows from the first samples to as many of the second as fill whole blocks, then in rows from
// the other second samples back to the first.
constexpr int samples_in_blocks(int count) { return count / block_lanes * block_lanes; }
constexpr int blocks_of(int count) { return (count + block_lanes - 1) / block_lanes; }

// The answer for the rods between `n` samples and `m` others; no rods before are needed for lengths alone.
template <int Width, Rod_query Query>
CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE Rod_answer answer(const Rod_block* rods, const Sample_lanes& first, int n,
                                                          const Sample_lanes& second, int m)
{
  static_assert(maximum_blocks == 3, "a case for every number of blocks");
  const int in_blocks = samples_in_blocks(m), blocks = blocks_of(in_blocks), back_blocks = blocks_of(n);
  const Rod_block* back = Query == Rod_query::LEAST_LENGTH ? nullptr : rods + n * blocks;
  Rod_totals<Width> totals;
  if (blocks == 1) add_rows<Width, 1, Query>(rods, first, 0, n, second, totals);
  if (blocks == 2) add_rows<Width, 2, Query>(rods, first, 0, n, second, totals);
  if (in_blocks < m) {
    if (back_blocks == 1) add_rows<Width, 1, Query>(back, second, in_blocks, m, first, totals);
    if (back_blocks == 2) add_rows<Width, 2, Query>(back, second, in_blocks, m, first, totals);
    if (back_blocks == 3) add_rows<Width, 3, Query>(back, second, in_blocks, m, first, totals);
  }
  alignas(64) float cosines[block_lanes], least[block_lanes];
  std::memcpy(cosines, totals.cosines, sizeof cosines);
  std::memcpy(least, totals.least, sizeof least);
  Rod_answer result{0, far_away * far_away};
  if (Query != Rod_query::LEAST_LENGTH) result.squared_cosines = sum_of_block<Width>(cosines);
  if (Query != Rod_query::SQUARED_COSINES) result.least_squared_length = *std::min_element(least, least + block_lanes);
  return result;
}

using Rod_kernel = Rod_answer (*)(const Rod_block* rods, const Sample_lanes& first, int n, const Sample_lanes& second,
                                  int m);

// For each query
struct Rod_kernels
{
  Rod_kernel squared_cosines, least_length, both;
};

#define CGAL_SHAPE_CORRESPONDENCE_ROD_KERNEL(name, instructions, width, query)                                         \
  CGAL_SHAPE_CORRESPONDENCE_TARGET(instructions)                                                                       \
  Rod_answer name(const Rod_block* rods, const Sample_lanes& first, int n, const Sample_lanes& second, int m)          \
  {                                                                                                                    \
    return answer<width, Rod_query::query>(rods, first, n, second, m);                                                 \
  }
#define CGAL_SHAPE_CORRESPONDENCE_ROD_KERNELS(name, instructions, width)                                               \
  CGAL_SHAPE_CORRESPONDENCE_ROD_KERNEL(squared_cosines_##name, instructions, width, SQUARED_COSINES)                   \
  CGAL_SHAPE_CORRESPONDENCE_ROD_KERNEL(least_length_##name, instructions, width, LEAST_LENGTH)                         \
  CGAL_SHAPE_CORRESPONDENCE_ROD_KERNEL(both_##name, instructions, width, BOTH)                                         \
  constexpr Rod_kernels rod_kernels_##name{squared_cosines_##name, least_length_##name, both_##name};
#ifdef CGAL_SHAPE_CORRESPONDENCE_X86
CGAL_SHAPE_CORRESPONDENCE_ROD_KERNELS(sse2, "sse2", 4)
CGAL_SHAPE_CORRESPONDENCE_ROD_KERNELS(avx2, "avx2", 8)
CGAL_SHAPE_CORRESPONDENCE_ROD_KERNELS(avx512, "avx512f", 16)
#else
CGAL_SHAPE_CORRESPONDENCE_ROD_KERNELS(plain, "", 1)
#endif
#undef CGAL_SHAPE_CORRESPONDENCE_ROD_KERNELS
#undef CGAL_SHAPE_CORRESPONDENCE_ROD_KERNEL

// The kernels that this machine can run, the fastest one last.
inline std::vector<Rod_kernels> available_rod_kernels()
{
#ifdef CGAL_SHAPE_CORRESPONDENCE_X86
  std::vector<Rod_kernels> kernels{rod_kernels_sse2};
  if (__builtin_cpu_supports("avx2")) kernels.push_back(rod_kernels_avx2);
  if (__builtin_cpu_supports("avx512f")) kernels.push_back(rod_kernels_avx512);
  return kernels;
#else
  return {rod_kernels_plain};
#endif
}

inline const Rod_kernels& rod_kernels()
{
  static const Rod_kernels fastest = available_rod_kernels().back();
  return fastest;
}

} // namespace internal
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_INTERNAL_ROD_KERNEL_H

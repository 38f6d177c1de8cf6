// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_INTERNAL_ROD_KERNEL_H
#define CGAL_SHAPE_CORRESPONDENCE_INTERNAL_ROD_KERNEL_H

#include <CGAL/Shape_correspondence/Points.h>
#include <CGAL/Shape_correspondence/internal/vector_functions.h>

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

// A block of lanes in memory. A copy by memcpy() would go through the stack in narrower pieces.
template <int Width>
CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE const typename Lane_vector<Width>::type& lanes_at(const float* lanes, int block)
{
  return *reinterpret_cast<const typename Lane_vector<Width>::type*>(lanes + block * Width);
}

// For a vector of lanes of a block: the squared cosine between before and after, 0 beyond a right angle, as a fraction.
template <int Width, typename Lanes>
CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE void squared_cosine(const Rod_block& block, int in_block,
                                                            const float (&from)[3], const Sample_lanes& to, int lanes,
                                                            Lanes& numerator, Lanes& denominator)
{
#ifdef __clang__
#pragma STDC FP_CONTRACT OFF
#endif
  const Lanes x = lanes_at<Width>(to.coordinates[0], lanes) - from[0],
              y = lanes_at<Width>(to.coordinates[1], lanes) - from[1],
              z = lanes_at<Width>(to.coordinates[2], lanes) - from[2];
  Lanes product = lanes_at<Width>(block.direction[0], in_block) * x +
                  lanes_at<Width>(block.direction[1], in_block) * y + lanes_at<Width>(block.direction[2], in_block) * z;
  keep_positive<Width>(product);
  numerator = product * product;
  denominator = x * x + y * y + z * z + zero_rod;
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

// Adds the squared cosines of rods, up to a block: those of row i, of `Blocks` blocks, go from sample `first_row` + i
// of `from` to the first samples of `to`. Rows are taken in pairs, whose fractions share a division, the slowest of the
// operations.
template <int Width, int Blocks, typename Lanes>
CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE void add_rows(const Rod_block* rods, int row_count, const Sample_lanes& from,
                                                      int first_row, const Sample_lanes& to,
                                                      Lanes (&block_sum)[block_lanes / Width])
{
#ifdef __clang__
#pragma STDC FP_CONTRACT OFF
#endif
  constexpr int in_block = block_lanes / Width, count = Blocks * in_block;
  Lanes sums[count] = {}, numerator, denominator, other_numerator, other_denominator;
  const auto& at = from.coordinates;
  int i = first_row;
  const int end = first_row + row_count;
  for (; i + 1 < end; i += 2, rods += 2 * Blocks) {
    const float start[3] = {at[0][i], at[1][i], at[2][i]};
    const float other_start[3] = {at[0][i + 1], at[1][i + 1], at[2][i + 1]};
#pragma GCC unroll 12
    for (int l = 0; l < count; ++l) {
      const Rod_block* block = rods + l / in_block;
      squared_cosine<Width>(block[0], l % in_block, start, to, l, numerator, denominator);
      squared_cosine<Width>(block[Blocks], l % in_block, other_start, to, l, other_numerator, other_denominator);
      sums[l] += (numerator * other_denominator + other_numerator * denominator) / (denominator * other_denominator);
    }
  }
  if (i < end) {
    const float start[3] = {at[0][i], at[1][i], at[2][i]};
#pragma GCC unroll 12
    for (int l = 0; l < count; ++l) {
      squared_cosine<Width>(rods[l / in_block], l % in_block, start, to, l, numerator, denominator);
      sums[l] += numerator / denominator;
    }
  }
#pragma GCC unroll 12
  for (int l = 0; l < count; ++l)
    block_sum[l % in_block] += sums[l];
}

// The layout of rods: in rows from the first samples to as many of the second as fill whole blocks, then in rows from
// the other second samples back to the first.
constexpr int samples_in_blocks(int count) { return count / block_lanes * block_lanes; }
constexpr int blocks_of(int count) { return (count + block_lanes - 1) / block_lanes; }

// Sum of the squared cosines of the rods between `first_count` and `second_count` samples.
template <int Width>
CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE double squared_cosines(const Rod_block* rods, const Sample_lanes& first,
                                                               int first_count, const Sample_lanes& second,
                                                               int second_count)
{
  static_assert(maximum_blocks == 3, "a case for every number of blocks");
  const int in_blocks = samples_in_blocks(second_count), blocks = blocks_of(in_blocks);
  const int back_rows = second_count - in_blocks, back_blocks = back_rows > 0 ? blocks_of(first_count) : 0;
  typename Lane_vector<Width>::type sum[block_lanes / Width] = {};
  if (blocks == 1) add_rows<Width, 1>(rods, first_count, first, 0, second, sum);
  if (blocks == 2) add_rows<Width, 2>(rods, first_count, first, 0, second, sum);
  rods += first_count * blocks;
  if (back_blocks == 1) add_rows<Width, 1>(rods, back_rows, second, in_blocks, first, sum);
  if (back_blocks == 2) add_rows<Width, 2>(rods, back_rows, second, in_blocks, first, sum);
  if (back_blocks == 3) add_rows<Width, 3>(rods, back_rows, second, in_blocks, first, sum);
  alignas(64) float lanes[block_lanes];
  std::memcpy(lanes, sum, sizeof lanes);
  return double(sum_of_block<Width>(lanes));
}

// Least squared distance of the first `count` points of `first` to points of `second`.
template <int Width>
CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE float least_squared_distance(const Sample_lanes& first, int count,
                                                                     const Sample_lanes& second)
{
#ifdef __clang__
#pragma STDC FP_CONTRACT OFF
#endif
  using Lanes = typename Lane_vector<Width>::type;
  constexpr int blocks = lane_count / Width;
  const Lanes zero = {};
  Lanes least = zero + far_away * far_away;
  for (int i = 0; i < count; ++i)
    for (int b = 0; b < blocks; ++b) {
      Lanes squares = zero;
      for (int axis = 0; axis < 3; ++axis) {
        const Lanes difference = lanes_at<Width>(second.coordinates[axis], b) - (zero + first.coordinates[axis][i]);
        squares += difference * difference;
      }
      least = squares < least ? squares : least;
    }
  float lanes[Width], result = far_away * far_away;
  std::memcpy(lanes, &least, sizeof lanes);
  for (float lane : lanes)
    result = lane < result ? lane : result;
  return result;
}

struct Rod_kernels
{
  double (*squared_cosines)(const Rod_block*, const Sample_lanes&, int, const Sample_lanes&, int);
  float (*least_squared_distance)(const Sample_lanes&, int, const Sample_lanes&);
};

#define CGAL_SHAPE_CORRESPONDENCE_ROD_KERNELS(name, instructions, width)                                               \
  CGAL_SHAPE_CORRESPONDENCE_TARGET(instructions)                                                                       \
  double squared_cosines_##name(const Rod_block* rods, const Sample_lanes& first, int first_count,                     \
                                const Sample_lanes& second, int second_count)                                          \
  {                                                                                                                    \
    return squared_cosines<width>(rods, first, first_count, second, second_count);                                     \
  }                                                                                                                    \
  CGAL_SHAPE_CORRESPONDENCE_TARGET(instructions)                                                                       \
  float least_squared_distance_##name(const Sample_lanes& first, int count, const Sample_lanes& second)                \
  {                                                                                                                    \
    return least_squared_distance<width>(first, count, second);                                                        \
  }
#ifdef CGAL_SHAPE_CORRESPONDENCE_X86
CGAL_SHAPE_CORRESPONDENCE_ROD_KERNELS(sse2, "sse2", 4)
CGAL_SHAPE_CORRESPONDENCE_ROD_KERNELS(avx2, "avx2", 8)
CGAL_SHAPE_CORRESPONDENCE_ROD_KERNELS(avx512, "avx512f", 16)
#else
CGAL_SHAPE_CORRESPONDENCE_ROD_KERNELS(plain, "", 1)
#endif
#undef CGAL_SHAPE_CORRESPONDENCE_ROD_KERNELS

// The kernels that this machine can run, the fastest one last.
inline std::vector<Rod_kernels> available_rod_kernels()
{
#ifdef CGAL_SHAPE_CORRESPONDENCE_X86
  std::vector<Rod_kernels> kernels{{squared_cosines_sse2, least_squared_distance_sse2}};
  if (__builtin_cpu_supports("avx2")) kernels.push_back({squared_cosines_avx2, least_squared_distance_avx2});
  if (__builtin_cpu_supports("avx512f")) kernels.push_back({squared_cosines_avx512, least_squared_distance_avx512});
  return kernels;
#else
  return {{squared_cosines_plain, least_squared_distance_plain}};
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

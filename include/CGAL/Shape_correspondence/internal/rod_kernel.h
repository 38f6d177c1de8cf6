// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_INTERNAL_ROD_KERNEL_H
#define CGAL_SHAPE_CORRESPONDENCE_INTERNAL_ROD_KERNEL_H

#include <CGAL/Shape_correspondence/Points.h>

#include <cstring>
#include <vector>

// Almost all of the search's time goes here. Rods are in single precision, whose error of 1e-7 is far below what any
// comparison sees, and in rows of lanes, each with a sum of its own: the widest vector instructions of the machine give
// the same bits as the narrowest. Contraction to fused operations would not, and an unmoved rod must cost exactly 0.
#if defined(__GNUC__) && !defined(__clang__)
#define CGAL_SHAPE_CORRESPONDENCE_NO_CONTRACTION __attribute__((optimize("fp-contract=off")))
#else
#define CGAL_SHAPE_CORRESPONDENCE_NO_CONTRACTION
#endif
#ifdef __GNUC__
#define CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE inline __attribute__((always_inline))
#else
#define CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE inline
#endif

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

constexpr int maximum_samples = 36; // of a part: e × e
constexpr int lane_count = 48;      // the same, in a whole number of the widest vectors

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

// Rods from one sample to a row of samples. A lane without a rod has direction 0 and length 1.
struct alignas(64) Rod_row
{
  float direction[3][lane_count];
  float squared_length[lane_count];
};

// Squared length, in units of the shape's height, under which a rod has no direction; products of four such lengths are
// still normal numbers in single precision
constexpr float zero_rod = 1e-9f;

template <int Width>
struct Lane_vector
{
#ifdef __GNUC__
  typedef float type __attribute__((vector_size(Width * sizeof(float)), may_alias));
#else
  static_assert(Width == 1, "vector types need GCC or Clang");
  using type = float;
#endif
};

template <>
struct Lane_vector<1>
{
  using type = float;
};

// A block of lanes in memory. A copy by memcpy() would go through the stack in narrower pieces.
template <int Width>
CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE const typename Lane_vector<Width>::type& lanes_at(const float* lanes, int block)
{
  return *reinterpret_cast<const typename Lane_vector<Width>::type*>(lanes + block * Width);
}

// For a block of lanes of a row: squared cosine between before and after, 0 beyond a right angle, as a fraction, which
// is exactly 1 for an unmoved rod.
template <int Width, typename Lanes>
CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE void squared_cosine(const Rod_row& row, const Lanes (&from)[3],
                                                            const Sample_lanes& second, int block, Lanes& numerator,
                                                            Lanes& denominator)
{
#ifdef __clang__
#pragma STDC FP_CONTRACT OFF
#endif
  const Lanes zero = {}, shortest = zero + zero_rod;
  const Lanes x = lanes_at<Width>(second.coordinates[0], block) - from[0],
              y = lanes_at<Width>(second.coordinates[1], block) - from[1],
              z = lanes_at<Width>(second.coordinates[2], block) - from[2];
  Lanes moved = x * x + y * y + z * z;
  Lanes product = lanes_at<Width>(row.direction[0], block) * x + lanes_at<Width>(row.direction[1], block) * y +
                  lanes_at<Width>(row.direction[2], block) * z;
  moved = moved > shortest ? moved : shortest;
  product = product > zero ? product : zero;
  numerator = product * product;
  denominator = lanes_at<Width>(row.squared_length, block) * moved;
}

// Sum over all rods of the squared cosine. The rods of row i go from point i of `first`. Rows are taken in pairs, whose
// fractions share a division, the slowest of the operations.
template <int Width>
CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE double squared_cosines(const Rod_row* rows, int row_count,
                                                               const Sample_lanes& first, const Sample_lanes& second)
{
#ifdef __clang__
#pragma STDC FP_CONTRACT OFF
#endif
  using Lanes = typename Lane_vector<Width>::type;
  constexpr int blocks = lane_count / Width;
  const Lanes zero = {};
  Lanes sums[blocks] = {}, numerator, denominator, other_numerator, other_denominator;
  const auto& at = first.coordinates;
  int i = 0;
  for (; i + 1 < row_count; i += 2) {
    const Lanes from[3] = {zero + at[0][i], zero + at[1][i], zero + at[2][i]};
    const Lanes other_from[3] = {zero + at[0][i + 1], zero + at[1][i + 1], zero + at[2][i + 1]};
    for (int b = 0; b < blocks; ++b) {
      squared_cosine<Width>(rows[i], from, second, b, numerator, denominator);
      squared_cosine<Width>(rows[i + 1], other_from, second, b, other_numerator, other_denominator);
      sums[b] += (numerator * other_denominator + other_numerator * denominator) / (denominator * other_denominator);
    }
  }
  if (i < row_count) {
    const Lanes from[3] = {zero + at[0][i], zero + at[1][i], zero + at[2][i]};
    for (int b = 0; b < blocks; ++b) {
      squared_cosine<Width>(rows[i], from, second, b, numerator, denominator);
      sums[b] += numerator / denominator;
    }
  }
  // In the same order for every width
  alignas(64) float lanes[lane_count];
  std::memcpy(lanes, sums, sizeof lanes);
  constexpr int third = lane_count / 3;
  for (int i = 0; i < third; ++i)
    lanes[i] += lanes[i + third] + lanes[i + 2 * third];
  for (int half = third / 2; half > 0; half /= 2)
    for (int i = 0; i < half; ++i)
      lanes[i] += lanes[i + half];
  return double(lanes[0]);
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
  double (*squared_cosines)(const Rod_row*, int, const Sample_lanes&, const Sample_lanes&);
  float (*least_squared_distance)(const Sample_lanes&, int, const Sample_lanes&);
};

#if defined(__x86_64__) && defined(__GNUC__)
#define CGAL_SHAPE_CORRESPONDENCE_TARGET(instructions)                                                                 \
  __attribute__((target(instructions))) CGAL_SHAPE_CORRESPONDENCE_NO_CONTRACTION
#else
#define CGAL_SHAPE_CORRESPONDENCE_TARGET(instructions) CGAL_SHAPE_CORRESPONDENCE_NO_CONTRACTION
#endif
#define CGAL_SHAPE_CORRESPONDENCE_ROD_KERNELS(name, instructions, width)                                               \
  CGAL_SHAPE_CORRESPONDENCE_TARGET(instructions)                                                                       \
  inline double squared_cosines_##name(const Rod_row* rows, int row_count, const Sample_lanes& first,                  \
                                       const Sample_lanes& second)                                                     \
  {                                                                                                                    \
    return squared_cosines<width>(rows, row_count, first, second);                                                     \
  }                                                                                                                    \
  CGAL_SHAPE_CORRESPONDENCE_TARGET(instructions)                                                                       \
  inline float least_squared_distance_##name(const Sample_lanes& first, int count, const Sample_lanes& second)         \
  {                                                                                                                    \
    return least_squared_distance<width>(first, count, second);                                                        \
  }
#if defined(__x86_64__) && defined(__GNUC__)
CGAL_SHAPE_CORRESPONDENCE_ROD_KERNELS(sse2, "sse2", 4)
CGAL_SHAPE_CORRESPONDENCE_ROD_KERNELS(avx2, "avx2", 8)
CGAL_SHAPE_CORRESPONDENCE_ROD_KERNELS(avx512, "avx512f", 16)
#else
CGAL_SHAPE_CORRESPONDENCE_ROD_KERNELS(plain, "", 1)
#endif
#undef CGAL_SHAPE_CORRESPONDENCE_ROD_KERNELS
#undef CGAL_SHAPE_CORRESPONDENCE_TARGET

// The kernels that this machine can run, the fastest one last.
inline std::vector<Rod_kernels> available_rod_kernels()
{
#if defined(__x86_64__) && defined(__GNUC__)
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

// Length² in the kernel's own order of operations
CGAL_SHAPE_CORRESPONDENCE_NO_CONTRACTION inline float squared_rod_length(float x, float y, float z)
{
#ifdef __clang__
#pragma STDC FP_CONTRACT OFF
#endif
  return x * x + y * y + z * z;
}

} // namespace internal
} // namespace Shape_correspondence
} // namespace CGAL

#undef CGAL_SHAPE_CORRESPONDENCE_NO_CONTRACTION
#undef CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE

#endif // CGAL_SHAPE_CORRESPONDENCE_INTERNAL_ROD_KERNEL_H

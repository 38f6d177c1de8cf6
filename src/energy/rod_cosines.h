// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "base/vector_functions.h"
#include "energy/Sample_lanes.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

// Eq. 2: the squared cosines of the angles by which structural rods turn, summed. Almost all of the search's time goes
// here. Rods are in single precision, whose error of 1e-7 is far below what any comparison sees, and in lanes, each
// with a sum of its own: the widest vector instructions of the machine give the same bits as the narrowest. Contraction
// to fused operations would not. By hand, since a library is compiled for one set of instructions: 5.1 rods a
// nanosecond with AVX-512, 4.8 with AVX2, 1.4 with SSE2 and 0.4 with none, against 1.7 of the same sums by Eigen's
// arrays (on an AVX-512 machine).

namespace CGAL::Shape_correspondence::internal {

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
  using bits = std::int32_t;
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

// x becomes max(x, `zero_rod`), where it is not negative.
template <int Width>
CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE void keep_from_zero(typename Lane_vector<Width>::type& x)
{
  if constexpr (Width == 1) {
    x = x > zero_rod ? x : zero_rod;
  } else {
    using Lanes = typename Lane_vector<Width>::type;
    using Bits = typename Lane_vector<Width>::bits;
    const Lanes least = Lanes{} + zero_rod;
    const Bits a = reinterpret_cast<Bits>(x), b = reinterpret_cast<Bits>(least);
    x = reinterpret_cast<Lanes>(a > b ? a : b);
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
  return *reinterpret_cast<const typename Lane_vector<Width>::type*>(lanes + std::ptrdiff_t(block) * Width);
}

// For a vector of lanes, from `from` to a block of `to`: the rods and their squared lengths.
template <int Width, typename Lanes>
CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE void find_rods(const float (&from)[3], const Sample_lanes& to, int lanes,
                                                       Lanes (&rod)[3], Lanes& squared_length)
{
#ifdef __clang__
#pragma STDC FP_CONTRACT OFF
#endif
  for (int axis = 0; axis < 3; ++axis)
    rod[axis] = lanes_at<Width>(to.coordinates[axis], lanes) - from[axis];
  squared_length = rod[0] * rod[0] + rod[1] * rod[1] + rod[2] * rod[2];
}

// For a vector of lanes of a block: the squared lengths of rods along the directions before.
template <int Width, typename Lanes>
CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE void find_squared_along(const Rod_block& before, int in_block,
                                                                const Lanes (&rod)[3], Lanes& squared)
{
#ifdef __clang__
#pragma STDC FP_CONTRACT OFF
#endif
  Lanes product = lanes_at<Width>(before.direction[0], in_block) * rod[0] +
                  lanes_at<Width>(before.direction[1], in_block) * rod[1] +
                  lanes_at<Width>(before.direction[2], in_block) * rod[2];
  keep_positive<Width>(product);
  squared = product * product;
}

// What is asked about rods: how far they keep their directions, compared with those of `Sources` pairs of parts before,
// as a sum of squared cosines (Eq. 2, 0 beyond a right angle) over all rods that have a direction; and how short the
// shortest is.
template <int Sources>
struct Rod_answer
{
  float squared_cosines[std::max(Sources, 1)] = {};
  float least_squared_length = 0; // where it is asked for
};

// An answer up to a block of lanes.
template <int Width, int Sources>
struct Rod_totals
{
  using Lanes = typename Lane_vector<Width>::type;
  static constexpr int in_block = block_lanes / Width;

  Lanes cosines[std::max(Sources, 1)][in_block] = {}, least[in_block];

  Rod_totals()
  {
    for (Lanes& lanes : least)
      lanes = Lanes{} + far_away * far_away;
  }
};

// Rods in rows of `Blocks` blocks: those of row i go from sample i of `from`, between `begin` and `end`, to the first
// samples of `to`; the rods before begin `at_block` blocks behind `rods`. Rows are taken in pairs, which share a
// division, the slowest of the operations.
template <int Width, int Blocks, int Sources, bool Least>
CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE void add_rows(const Rod_block* const* rods, int at_block,
                                                      const Sample_lanes& from, int begin, int end,
                                                      const Sample_lanes& to, Rod_totals<Width, Sources>& totals)
{
#ifdef __clang__
#pragma STDC FP_CONTRACT OFF
#endif
  using Lanes = typename Lane_vector<Width>::type;
  constexpr int in_block = block_lanes / Width;
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
        keep_least<Width>(totals.least[k], length);
        keep_least<Width>(totals.least[k], next_length);
      }
      if constexpr (Sources > 0) {
        keep_from_zero<Width>(length);
        keep_from_zero<Width>(next_length);
        const Lanes both = 1.0f / (length * next_length), inverse = both * next_length,
                    next_inverse = is_pair ? both * length : Lanes{};
#pragma GCC unroll 4
        for (int s = 0; s < Sources; ++s) {
          Lanes squared, next_squared;
          find_squared_along<Width>(rods[s][row + block], k, rod, squared);
          find_squared_along<Width>(rods[s][next_row + block], k, next_rod, next_squared);
          totals.cosines[s][k] += squared * inverse + next_squared * next_inverse;
        }
      }
    }
  }
}

// The same for all `n` samples of `from`, of which several are equal: the rods that they have after the deformation are
// found once, and divided by once.
template <int Width, int Blocks, int Sources, bool Least>
CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE void add_equal_rows(const Rod_block* const* rods, const Sample_lanes& from,
                                                            int n, const Sample_lanes& to,
                                                            Rod_totals<Width, Sources>& totals)
{
#ifdef __clang__
#pragma STDC FP_CONTRACT OFF
#endif
  using Lanes = typename Lane_vector<Width>::type;
  constexpr int in_block = block_lanes / Width;
  const auto& at = from.coordinates;
  const int repeats = from.repeats, stride = from.stride;
  for (int group = 0; group < n / repeats; ++group) {
    const int first = stride == 1 ? group * repeats : group;
    const float start[3] = {at[0][first], at[1][first], at[2][first]};
    for (int l = 0; l < Blocks * in_block; ++l) {
      const int block = l / in_block, k = l % in_block;
      Lanes rod[3], length;
      find_rods<Width>(start, to, l, rod, length);
      if constexpr (Least) keep_least<Width>(totals.least[k], length);
      if constexpr (Sources > 0) {
        keep_from_zero<Width>(length);
        const Lanes inverse = 1.0f / length;
#pragma GCC unroll 4
        for (int s = 0; s < Sources; ++s) {
          const Rod_block* before = rods[s] + std::ptrdiff_t(first) * Blocks + block;
          Lanes sum = {};
          for (int i = 0; i < repeats; ++i, before += std::ptrdiff_t(stride) * Blocks) {
            Lanes squared;
            find_squared_along<Width>(*before, k, rod, squared);
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

// The answer for the rods between `n` samples and `m` others.
template <int Width, int Sources, bool Least>
CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE Rod_answer<Sources>
answer(const Rod_block* const* rods, const Sample_lanes& first, int n, const Sample_lanes& second, int m)
{
  static_assert(maximum_blocks == 3, "a case for every number of blocks");
  const int in_blocks = samples_in_blocks(m), blocks = blocks_of(in_blocks), back_blocks = blocks_of(n);
  const int back = n * blocks;
  Rod_totals<Width, Sources> totals;
  if (blocks == 1) add_rows<Width, 1, Sources, Least>(rods, 0, first, 0, n, second, totals);
  if (blocks == 2 && first.repeats > 1)
    add_equal_rows<Width, 2, Sources, Least>(rods, first, n, second, totals);
  else if (blocks == 2)
    add_rows<Width, 2, Sources, Least>(rods, 0, first, 0, n, second, totals);
  if (in_blocks < m) {
    if (back_blocks == 1) add_rows<Width, 1, Sources, Least>(rods, back, second, in_blocks, m, first, totals);
    if (back_blocks == 2) add_rows<Width, 2, Sources, Least>(rods, back, second, in_blocks, m, first, totals);
    if (back_blocks == 3) add_rows<Width, 3, Sources, Least>(rods, back, second, in_blocks, m, first, totals);
  }
  Rod_answer<Sources> result;
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

template <int Sources>
using Rod_kernel = Rod_answer<Sources> (*)(const Rod_block* const* rods, const Sample_lanes& first, int n,
                                           const Sample_lanes& second, int m);

// The least length alone, with it the rods of one pair before, or without it those of one, two or four.
struct Rod_kernels
{
  const char* name; // of the vector instructions
  Rod_kernel<0> least_length;
  Rod_kernel<1> both, one;
  Rod_kernel<2> two;
  Rod_kernel<4> four;
};

#define CGAL_SHAPE_CORRESPONDENCE_ROD_KERNEL(name, instructions, bytes, sources, least)                                \
  CGAL_SHAPE_CORRESPONDENCE_TARGET(instructions)                                                                       \
  Rod_answer<sources> name(const Rod_block* const* rods, const Sample_lanes& first, int n, const Sample_lanes& second, \
                           int m)                                                                                      \
  {                                                                                                                    \
    return answer<vector_width<float>(bytes), sources, least>(rods, first, n, second, m);                              \
  }
#define CGAL_SHAPE_CORRESPONDENCE_ROD_KERNELS(name, instructions, bytes)                                               \
  CGAL_SHAPE_CORRESPONDENCE_ROD_KERNEL(least_length_##name, instructions, bytes, 0, true)                              \
  CGAL_SHAPE_CORRESPONDENCE_ROD_KERNEL(both_##name, instructions, bytes, 1, true)                                      \
  CGAL_SHAPE_CORRESPONDENCE_ROD_KERNEL(one_##name, instructions, bytes, 1, false)                                      \
  CGAL_SHAPE_CORRESPONDENCE_ROD_KERNEL(two_##name, instructions, bytes, 2, false)                                      \
  CGAL_SHAPE_CORRESPONDENCE_ROD_KERNEL(four_##name, instructions, bytes, 4, false)                                     \
  constexpr Rod_kernels rod_kernels_##name{#name,      least_length_##name, both_##name,                               \
                                           one_##name, two_##name,          four_##name};
CGAL_SHAPE_CORRESPONDENCE_FOR_INSTRUCTIONS(CGAL_SHAPE_CORRESPONDENCE_ROD_KERNELS)
#undef CGAL_SHAPE_CORRESPONDENCE_ROD_KERNELS
#undef CGAL_SHAPE_CORRESPONDENCE_ROD_KERNEL

// The kernels that this machine can run, the fastest one last.
inline std::vector<Rod_kernels> available_rod_kernels()
{
  return runnable<Rod_kernels>(CGAL_SHAPE_CORRESPONDENCE_VERSIONS(rod_kernels_));
}

inline const Rod_kernels& rod_kernels()
{
  static const Rod_kernels fastest = available_rod_kernels().back();
  return fastest;
}

} // namespace CGAL::Shape_correspondence::internal

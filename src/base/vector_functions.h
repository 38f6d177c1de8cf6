// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <initializer_list>
#include <vector>

// Functions that are compiled for several instruction sets, the best of which is chosen when the program runs. They
// give the same bits as long as no multiplication and addition are fused (FMA), which an option forbids for the
// package.
#ifdef __GNUC__
#define CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE inline __attribute__((always_inline))
#else
#define CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE inline
#endif

#if defined(__x86_64__) && defined(__GNUC__)
#define CGAL_SHAPE_CORRESPONDENCE_X86
#define CGAL_SHAPE_CORRESPONDENCE_TARGET(instructions) __attribute__((target(instructions))) inline
#else
#define CGAL_SHAPE_CORRESPONDENCE_TARGET(instructions) inline
#endif

// `define(name, instructions, bytes)` for every instruction set of the compiler, with the size of a vector; 0: scalars.
// And the list of the functions that are so defined, whose names are `prefix` and `name`.
#ifdef CGAL_SHAPE_CORRESPONDENCE_X86
#define CGAL_SHAPE_CORRESPONDENCE_FOR_INSTRUCTIONS(define)                                                             \
  define(plain, "sse2", 0) define(sse2, "sse2", 16) define(avx2, "avx2", 32) define(avx512, "avx512f", 64)
#define CGAL_SHAPE_CORRESPONDENCE_VERSIONS(prefix)                                                                     \
  {                                                                                                                    \
    prefix##plain, prefix##sse2, prefix##avx2, prefix##avx512                                                          \
  }
#else
#define CGAL_SHAPE_CORRESPONDENCE_FOR_INSTRUCTIONS(define) define(plain, "", 0)
#define CGAL_SHAPE_CORRESPONDENCE_VERSIONS(prefix)                                                                     \
  {                                                                                                                    \
    prefix##plain                                                                                                      \
  }
#endif

namespace CGAL::Shape_correspondence::internal {

/// A vector of numbers, that may be where such numbers are in memory.
template <typename Number, int Width, int Alignment = Width* int(sizeof(Number))>
struct Vector_of
{
#ifdef __GNUC__
  typedef Number type __attribute__((vector_size(Width * sizeof(Number)), aligned(Alignment), may_alias));
#else
  static_assert(Width == 1, "vector types need GCC or Clang");
#endif
};

template <typename Number, int Alignment>
struct Vector_of<Number, 1, Alignment>
{
  using type = Number;
};

/// Numbers in a vector.
template <typename Number>
constexpr int vector_width(int bytes)
{
  return bytes == 0 ? 1 : bytes / int(sizeof(Number));
}

/// The versions that this machine can run, the fastest one last. \param versions in the order of the macro
template <typename Version>
std::vector<Version> runnable(std::initializer_list<Version> versions)
{
  std::vector<Version> result(versions);
#ifdef CGAL_SHAPE_CORRESPONDENCE_X86
  if (!__builtin_cpu_supports("avx512f")) result.pop_back();
  if (!__builtin_cpu_supports("avx2")) result.pop_back();
#endif
  return result;
}

} // namespace CGAL::Shape_correspondence::internal

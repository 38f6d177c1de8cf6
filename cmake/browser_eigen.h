// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

// Included first in every source that Emscripten compiles for browsers. With SSE2, Eigen adds numbers in pairs. Here it
// uses Emscripten's emulation of SSE2, so that sums have the same order, and results the same digits, as on x86. The
// macros are set for Eigen only: CGAL would use instructions of x86, as would Eigen for the old GCC that clang claims
// to be.

#pragma once

#define __SSE__ 1
#define __SSE2__ 1
#include <emmintrin.h>
#undef __SSE__
#undef __SSE2__

#define EIGEN_MAX_STATIC_ALIGN_BYTES 16
#include <Eigen/src/Core/util/Macros.h>
#undef EIGEN_COMP_GNUC
#define EIGEN_COMP_GNUC 63
// By these values of x86, Eigen chooses how to multiply and invert matrices
#define EIGEN_ARCH_DEFAULT_NUMBER_OF_REGISTERS 16
#define EIGEN_DEFAULT_L1_CACHE_SIZE (48 * 1024) // bytes
#define EIGEN_DEFAULT_L2_CACHE_SIZE (2 * 1024 * 1024)
#define EIGEN_DEFAULT_L3_CACHE_SIZE (32 * 1024 * 1024)
#define EIGEN_VECTORIZE
#define EIGEN_VECTORIZE_SSE
#define EIGEN_VECTORIZE_SSE2

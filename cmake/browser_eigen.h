// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

// Included before all else where Emscripten compiles for browsers. Eigen adds numbers in pairs where it has SSE2. Here it has
// Emscripten's emulation of it, so that sums have the order, and results the digits, that they have on x86. Only Eigen may
// know: CGAL would use commands of x86, as Eigen does for compilers as old as clang says that it is.

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
// By these, Eigen chooses how to multiply and invert matrices
#define EIGEN_ARCH_DEFAULT_NUMBER_OF_REGISTERS 16
#define EIGEN_DEFAULT_L1_CACHE_SIZE (48 * 1024) // bytes
#define EIGEN_DEFAULT_L2_CACHE_SIZE (2 * 1024 * 1024)
#define EIGEN_DEFAULT_L3_CACHE_SIZE (32 * 1024 * 1024)
#define EIGEN_VECTORIZE
#define EIGEN_VECTORIZE_SSE
#define EIGEN_VECTORIZE_SSE2

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

// Functions that are compiled for several sets of vector instructions, of which the running machine takes its best.
// They give the same bits as long as no multiplication and addition are fused, which compilers do where they can.
#ifdef __GNUC__
#define CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE inline __attribute__((always_inline))
#else
#define CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE inline
#endif

#if defined(__GNUC__) && !defined(__clang__)
#define CGAL_SHAPE_CORRESPONDENCE_NO_CONTRACTION __attribute__((optimize("fp-contract=off")))
#else
#define CGAL_SHAPE_CORRESPONDENCE_NO_CONTRACTION // Clang: #pragma STDC FP_CONTRACT OFF in the body
#endif

#if defined(__x86_64__) && defined(__GNUC__)
#define CGAL_SHAPE_CORRESPONDENCE_X86
#define CGAL_SHAPE_CORRESPONDENCE_TARGET(instructions)                                                                 \
  __attribute__((target(instructions))) CGAL_SHAPE_CORRESPONDENCE_NO_CONTRACTION inline
#else
#define CGAL_SHAPE_CORRESPONDENCE_TARGET(instructions) CGAL_SHAPE_CORRESPONDENCE_NO_CONTRACTION inline
#endif

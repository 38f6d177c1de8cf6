// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

// A function that is compiled for several sets of vector instructions, the widest of which is chosen when the program
// is loaded. All give the same bits as long as no multiplication and addition are fused, which an option forbids for
// the package. Only the GNU loader can choose, and not under the thread sanitizer.
#if defined(__x86_64__) && defined(__gnu_linux__) && defined(__GNUC__) && !defined(__SANITIZE_THREAD__)
#define CGAL_SHAPE_CORRESPONDENCE_CLONED __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define CGAL_SHAPE_CORRESPONDENCE_CLONED
#endif

#ifdef __GNUC__ // into the clones
#define CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE inline __attribute__((always_inline))
#else
#define CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE inline
#endif

#ifdef __clang__ // which finds too little gain in some loops
#define CGAL_SHAPE_CORRESPONDENCE_VECTORIZED _Pragma("clang loop vectorize(enable)")
#else
#define CGAL_SHAPE_CORRESPONDENCE_VECTORIZED
#endif

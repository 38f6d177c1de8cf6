// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

// Compiles a function for several instruction sets, the widest of which is chosen when the program is loaded. All give
// the same bits, since contraction to fused multiply-add is disabled for the package. The choice needs the GNU loader,
// and does not work under the thread sanitizer.
#if defined(__x86_64__) && defined(__gnu_linux__) && defined(__GNUC__) && !defined(__SANITIZE_THREAD__)
#define CGAL_SHAPE_CORRESPONDENCE_CLONED __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define CGAL_SHAPE_CORRESPONDENCE_CLONED
#endif

#ifdef __GNUC__ // for functions that the clones call: they are inlined, so that they use the clone's instructions
#define CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE inline __attribute__((always_inline))
#else
#define CGAL_SHAPE_CORRESPONDENCE_ALWAYS_INLINE inline
#endif

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#if defined(__GNUC__) && !defined(__clang__) && __GNUC__ >= 12
// A false alarm of g++ 12 in the inlined std::set::swap() of two local sets in the flow.
#pragma GCC diagnostic ignored "-Wdangling-pointer"
#endif
#include <CGAL/Shape_correspondence/internal/abstraction/skeletonize_impl.h>

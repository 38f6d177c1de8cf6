// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_CONFIG_H
#define CGAL_SHAPE_CORRESPONDENCE_CONFIG_H

/// \file config.h
/// How the package is used: header-only (the default; every function is inline) or linked with the
/// library of `src/`, in which each body is compiled once (the target defines the macro below).
#ifdef CGAL_SHAPE_CORRESPONDENCE_COMPILED
#define CGAL_SHAPE_CORRESPONDENCE_INLINE
#else
#define CGAL_SHAPE_CORRESPONDENCE_INLINE inline
#endif

#define CGAL_SHAPE_CORRESPONDENCE_VERSION "0.1.0"

#endif // CGAL_SHAPE_CORRESPONDENCE_CONFIG_H

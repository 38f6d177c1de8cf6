// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// What a correspondence is for: maps and blends.
#include <CGAL/Shape_correspondence/blend_shapes.h>

#include <CGAL/Shape_correspondence/internal/blend_shapes_impl.h>

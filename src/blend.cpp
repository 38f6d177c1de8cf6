// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Maps and blends.
#include <CGAL/Shape_correspondence/Correspondence_map.h>
#include <CGAL/Shape_correspondence/blend_shapes.h>

#include <CGAL/Shape_correspondence/internal/Correspondence_map_impl.h>
#include <CGAL/Shape_correspondence/internal/blend_shapes_impl.h>
#include <CGAL/Shape_correspondence/internal/map/fill_section_impl.h>

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Shape_correspondence/internal/Segmented_shape_impl.h>
#include <CGAL/Shape_correspondence/internal/estimate_up_impl.h>

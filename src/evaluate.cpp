// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Shape_correspondence/evaluate_correspondence.h>

#include <CGAL/Shape_correspondence/internal/evaluate_correspondence_impl.h>

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "shape/Surface_patches.h"
#include "shape/Welded_triangles.h"

namespace CGAL::Shape_correspondence::internal {

/// For each triangle, the numbers, from 0 on, of the sheet, the component and the patch that it belongs to.
struct Triangle_pieces
{
  Numbers sheets, components, patches;
};

/// Measures the patches and finds which may be merged; of more than `most_patches`, only their number is set.
void measure_patches(const Welded_triangles& triangles, const Triangle_pieces& pieces, Surface_patches& surface);

} // namespace CGAL::Shape_correspondence::internal

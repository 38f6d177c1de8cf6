// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "base/planar_hull.h"

#include <array>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// A directed edge between vertices, counter-clockwise around the interior of a section.
using Section_side = std::array<int, 2>;

/// A triangulation of a planar section of a solid.
struct Section_filling
{
  Planar_points vertices; ///< vertices of the section, then intersections of its sides
  std::vector<std::array<int, 3>> triangles;
};

/// Fills the section of a solid with triangles that use each of its sides once, so that the solid stays closed. If
/// sides cross or vertices coincide, because the solid's surface touches itself, this takes degenerate triangles.
/// Usually O(n log n) for n sides.
Section_filling fill_section(const Planar_points& vertices, const std::vector<Section_side>& sides);

} // namespace CGAL::Shape_correspondence::internal

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "base/planar_hull.h"

#include <array>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// From vertex to vertex, counter-clockwise around what the sides of a section enclose.
using Section_side = std::array<int, 2>;

/// A triangulation of a section of a solid, in the plane.
struct Section_filling
{
  Planar_points vertices; ///< those of the section, then those where its sides cross each other
  std::vector<std::array<int, 3>> triangles;
};

/// Fills the section of a solid with triangles that run along each of its sides once, so that the solid stays closed.
/// Where sides cross each other or vertices are in one place, as they are if the solid's surface touches itself, that
/// takes triangles without area. O(n log n) for n sides, as a rule.
Section_filling fill_section(const Planar_points& vertices, const std::vector<Section_side>& sides);

} // namespace CGAL::Shape_correspondence::internal

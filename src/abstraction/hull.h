// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Points.h>
#include <CGAL/Shape_correspondence/version.h>

namespace CGAL::Shape_correspondence::internal {

struct Convex_hull
{
  Points vertices;
  double volume = 0; ///< 0 of flat points
};

Convex_hull convex_hull(const Points& points);

} // namespace CGAL::Shape_correspondence::internal

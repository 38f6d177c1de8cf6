// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_ABSTRACTION_HULL_H
#define CGAL_SHAPE_CORRESPONDENCE_ABSTRACTION_HULL_H

#include <CGAL/Shape_correspondence/Points.h>
#include <CGAL/Shape_correspondence/version.h>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

struct Convex_hull
{
  Points vertices;
  double volume = 0; ///< 0 of flat points
};

Convex_hull convex_hull(const Points& points);

} // namespace internal
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_ABSTRACTION_HULL_H

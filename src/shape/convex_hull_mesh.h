// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "shape/meshes.h"

#include <CGAL/Shape_correspondence/Points.h>

namespace CGAL::Shape_correspondence::internal {

/// The convex hull of points that do not lie in a plane, its faces triangles. Compiled once: CGAL's algorithm is 20 s
/// of compile time in every file that has it.
Halfedge_mesh convex_hull_mesh(const Points& points);

} // namespace CGAL::Shape_correspondence::internal

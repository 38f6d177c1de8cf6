// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Points.h>

#include <array>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

using Corners = std::array<int, 3>;
using Link = std::array<int, 2>; // index of a vertex of the polygon, and that of the next one

/// Triangles of a flat polygon, which may have holes. None if it crosses or touches itself.
/// \param border edges with the polygon on the left, sorted
/// \param within sorted vertices inside the polygon, which become corners of triangles
/// \param stretch a linear map applied before Delaunay triangulation, to settle ties of cocircular vertices
std::vector<Corners> divide_polygon(const std::vector<Point>& points, const std::vector<Link>& border,
                                    const std::vector<int>& within, const Point& normal,
                                    const Eigen::Matrix3d& stretch);

} // namespace CGAL::Shape_correspondence::internal

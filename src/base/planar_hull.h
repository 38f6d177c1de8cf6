// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <Eigen/Core>

#include <vector>

namespace CGAL::Shape_correspondence::internal {

using Planar_points = std::vector<Eigen::Vector2d>;

inline double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// The convex hull of points in the plane, counter-clockwise, by Andrew's monotone chain. Points within rounding noise
/// of an edge are no vertices. CGAL::convex_hull_2() is exact and keeps them: on 14 735 projections of modelled parts
/// (each part along three coordinate and three principal axes) it gave other vertices for 3 500, most of them seen
/// along principal axes, where points of one face come to lie in a line but for the last digit.
/// Time O(n log n) for n points.
Planar_points planar_hull(Planar_points points);

/// Direction of one side of the rectangle of least area around a convex polygon; it lies along one of its edges, the
/// first of those that give the least area but for rounding noise. CGAL::min_rectangle_2() lets the noise choose: of
/// the same 14 683 hulls that are polygons, it chose another side of the same rectangle for 7 106, and another
/// rectangle for 965. Time O(n²) for n vertices, 4 µs on average there.
Eigen::Vector2d least_rectangle_direction(const Planar_points& hull);

} // namespace CGAL::Shape_correspondence::internal

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <Eigen/Core>

#include <vector>

namespace CGAL::Shape_correspondence::internal {

using Planar_points = std::vector<Eigen::Vector2d>;

inline double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

inline Eigen::Vector2d quarter_turn(const Eigen::Vector2d& v) { return {-v.y(), v.x()}; }

/// The convex hull of points in the plane, counter-clockwise, by Andrew's monotone chain. Points within rounding noise
/// of an edge are no vertices. CGAL::convex_hull_2() is exact and keeps them, such as the points of a face that is seen
/// edge-on, which are on a line but for the last digit. Time O(n log n) for n points.
Planar_points planar_hull(Planar_points points);

/// Direction of that side of the rectangle of least area around a convex polygon whose angle from the x axis is in
/// (-45°, 45°]. It lies along or across an edge of the polygon; of rectangles whose areas are equal but for rounding
/// noise, as those of a regular polygon are, the one turned least from the axes is taken, to the left if two are.
/// CGAL::min_rectangle_2() lets the noise choose. Time O(n²) for n vertices.
Eigen::Vector2d least_rectangle_direction(const Planar_points& hull);

} // namespace CGAL::Shape_correspondence::internal

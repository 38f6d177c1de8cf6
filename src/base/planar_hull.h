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
/// of an edge are left out; CGAL::convex_hull_2() is exact and keeps them, for example the points of a face seen
/// edge-on, which are collinear up to the last digit. O(n log n) for n points.
Planar_points planar_hull(Planar_points points);

/// Direction of the side of the bounding rectangle of least area of a convex polygon, with angle from the x axis in
/// (-45°, 45°]. It is parallel or perpendicular to an edge of the polygon. Of rectangles with equal areas up to
/// rounding noise, as those of a regular polygon, the one turned least from the axes is taken, to the left in case of a
/// tie; CGAL::min_rectangle_2() lets the noise choose. O(n²) for n vertices.
Eigen::Vector2d least_rectangle_direction(const Planar_points& hull);

} // namespace CGAL::Shape_correspondence::internal

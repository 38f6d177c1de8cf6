// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "mesh.h"

namespace CGAL::Shape_correspondence::generator {

using Box = Eigen::AlignedBox3d;

Box box_of(const std::vector<Point>& points);

double squared_distance_to_segment(const Point& p, const Point& a, const Point& b);

double squared_distance(const Point& p, const Point& a, const Point& b, const Point& c);

/// Whether the segment from p to q goes through a triangle.
bool crosses(const Point& p, const Point& q, const Point& a, const Point& b, const Point& c);

/// Of two segments; that of the lines where it is between the ends of both, else that of an end.
double squared_distance_of_segments(const Point& a, const Point& b, const Point& c, const Point& d);

double squared_distance_of_triangles(const std::array<Point, 3>& a, const std::array<Point, 3>& b);

std::array<Point, 3> corners(const Mesh& mesh, const std::array<int, 3>& face);

/// The distance of two surfaces, where it is less than `limit`, by brute force: every face against every other.
double surface_distance(const Mesh& one, const Mesh& other, double limit);

} // namespace CGAL::Shape_correspondence::generator

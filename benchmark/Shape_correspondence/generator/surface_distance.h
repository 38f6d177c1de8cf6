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

/// The squared distance of the segments ab and cd: that of their lines if the nearest points of the lines are on the
/// segments, else the least one of an end from the other segment.
double squared_distance_of_segments(const Point& a, const Point& b, const Point& c, const Point& d);

double squared_distance_of_triangles(const std::array<Point, 3>& a, const std::array<Point, 3>& b);

std::array<Point, 3> corners(const Mesh& mesh, const std::array<int, 3>& face);

/// The distance of two surfaces, but `limit` if it is greater, by brute force: all pairs of faces.
double surface_distance(const Mesh& one, const Mesh& other, double limit);

} // namespace CGAL::Shape_correspondence::generator

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "mesh.h"

#include <functional>

namespace CGAL::Shape_correspondence::generator {

Point between(const Point& a, const Point& b, double t);

/// The points from `a` to `b` in `pieces` equal steps, both ends included.
Path line(const Point& a, const Point& b, int pieces = 5);

double length(const Path& path);

/// A Catmull-Rom curve through `knots`, `pieces` steps between neighbours.
Path spline(const Path& knots, int pieces = 4);

/// The left half of a curve (from the middle, where x is 0, outwards) continued to its mirror image, right to left.
Path with_mirror_image(const Path& left_half);

/// A polyline whose corners are rounded, starting `radius` before each; straight pieces are cut in `pieces`.
Path bent(const Path& corners, double radius, int pieces = 3);

/// `n` points of a circle about `axis`.
Path circle(const Point& centre, const Point& axis, double radius, int n);

/// The points of a cross-section, counter-clockwise.
using Ring_2 = std::vector<Point_2>;

/// The cross-section of a tube: `ring(t, inset)` is that at t in [0, 1] along it, with its outline moved inwards by
/// `inset`; `chamfer` is the width of the chamfer of both ends.
struct Section
{
  std::function<Ring_2(double, double)> ring;
  double chamfer;
};

constexpr double chamfer_ratio = 0.2;

/// An ellipse with `n` points, whose half axes change linearly from `start` to `end` along the tube.
Section oval(const Point_2& start, const Point_2& end, int n = 10);

Section round_section(double start, double end, int n = 10);

Section round_section(double radius, int n = 10);

/// A rectangle with bevelled corners and a point in the middle of each side; its width and height change linearly from
/// `start` to `end` along the tube.
Section bar(const Point_2& start, const Point_2& end);

Section bar(double width, double height);

} // namespace CGAL::Shape_correspondence::generator

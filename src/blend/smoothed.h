// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Points.h>

#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// By point, the first one in the same place, which joins triangles that share no points.
std::vector<int> first_in_place(const Points& points);

/// Vectors at the points of a surface, smoothed over about a length: w that minimises the integral of
/// |w - given|² + length² |grad w|² over the surface, by linear elements. Separate components are smoothed each by
/// itself.
Points smoothed(const Points& given, const Points& surface, const Eigen::Matrix3Xi& triangles, double length);

} // namespace CGAL::Shape_correspondence::internal

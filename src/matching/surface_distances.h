// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "matching/Normalized_shape.h"

#include <vector>

namespace CGAL::Shape_correspondence::internal {

// Distances of the points of the parts of one shape from the parts of another: [part](point, other part).
using Point_distances = std::vector<Eigen::ArrayXXd>;

// The mean distance of the points of either surface from the other one.
double chamfer(const Point_lanes& p, const Point_lanes& q);

void point_distances(const Normalized_shape& a, const Normalized_shape& b, Point_distances& a_from_b,
                     Point_distances& b_from_a);

// The chamfer distance of two parts.
double chamfer(const Point_distances& a_from_b, const Point_distances& b_from_a, std::size_t i, std::size_t j);

// The chamfer distance of a part and the union of several.
double chamfer(const Point_distances& a_from_b, const Point_distances& b_from_a, std::size_t i,
               const std::vector<std::size_t>& parts);

} // namespace CGAL::Shape_correspondence::internal

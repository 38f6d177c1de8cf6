// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "matching/Normalized_shape.h"

#include <CGAL/Shape_correspondence/Search_options.h>

#include <Eigen/Core>

namespace CGAL::Shape_correspondence::internal {

// The costs that do not depend on places.
double cost_of_kind(const Part_extent& a, const Part_extent& b, const Part_matching_options& options);

// The costs of places and extents.
Eigen::MatrixXd costs_of_boxes(const Measured_boxes& a, const Measured_boxes& b, const Part_matching_options& options);

// The mean of the costs of boxes as they are, and after either shape was warped towards the other where the pairs that
// are most probable by all costs ask for it; with the costs of kind.
Eigen::MatrixXd costs_after_warping(const Normalized_shape& a, const Normalized_shape& b,
                                    const Eigen::MatrixXd& costs_of_kind, const Part_matching_options& options);

} // namespace CGAL::Shape_correspondence::internal

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "base/deadline.h"
#include "matching/Shape_features.h"

#include <Eigen/Core>

namespace CGAL::Shape_correspondence {

namespace internal {

inline const Deadline no_deadline{};

} // namespace internal

/// The cost of every part of the source (row) corresponding to every part of the target (column), by index of the
/// aligned shapes. Symmetric: with the shapes swapped, the transposed matrix, to the bit unless they have the same
/// rank.
///
/// The boxes are compared as they are and after either shape was warped towards the other, axis by axis, where the most
/// alike parts ask for it; the three are averaged. A group of `repetition` parts or more, or a panel
/// (`Part_assemblies`), may cost less as a whole (legs for a pedestal, slats for a board). O(n m k²) for n and m parts
/// with k = `surface_samples` points each.
/// \param deadline for the distances of surfaces; null: there is no time for them, and boxes alone are compared
/// \throw internal::Out_of_time
Eigen::MatrixXd part_costs(const internal::Shape_features& source, const internal::Shape_features& target,
                           const Part_matching_options& options,
                           const internal::Deadline* deadline = &internal::no_deadline);

/// How badly two shapes go together: the mean of the least cost of every source part, and that of every target part,
/// added. \pre the matrix has rows and columns
double mean_least_cost(const Eigen::MatrixXd& costs);

} // namespace CGAL::Shape_correspondence

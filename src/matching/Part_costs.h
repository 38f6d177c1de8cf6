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
/// aligned shapes. Swapping the shapes transposes the matrix, bitwise unless both have the same `Shape_rank`.
///
/// Boxes are compared as given and after either shape was warped towards the other, axis by axis, by the most similar
/// parts; the three costs are averaged. A group of at least `repetition` parts, or a panel (`Part_assemblies`), may
/// cost less as a union (legs and a pedestal, slats and a board). O(n m k²) for n and m parts with k =
/// `surface_samples` points each.
/// \param deadline limits the comparison of surfaces; null: there is no time for it, and only boxes are compared
/// \throw internal::Out_of_time
Eigen::MatrixXd part_costs(const internal::Shape_features& source, const internal::Shape_features& target,
                           const Part_matching_options& options,
                           const internal::Deadline* deadline = &internal::no_deadline);

/// For source part × target part: the cosine of the features of both parts, minus the mean cosine of either part with
/// the parts of the other shape, times `Part_cost_weights::features`. 0 if one of the parts has no features. Empty if
/// the weight is 0, or one of the shapes has no features.
Eigen::MatrixXd evidence_of_features(const internal::Shape_features& source, const internal::Shape_features& target,
                                     const Part_matching_options& options);

/// Dissimilarity of two shapes: the mean over source parts of the least cost in the row, plus the mean over target
/// parts of the least cost in the column.
/// \pre the matrix is not empty
double mean_least_cost(const Eigen::MatrixXd& costs);

} // namespace CGAL::Shape_correspondence

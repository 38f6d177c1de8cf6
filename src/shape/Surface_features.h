// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/features_of_parts.h>

#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// Features of the surface of a model.
struct Surface_features
{
  const Eigen::MatrixXf& values; ///< one column for each face or vertex of the model
  /// By object and triangle, the columns at its three corners: those of the vertices, or thrice that of the face.
  std::vector<Eigen::Matrix3Xi> columns;
};

/// Throws `Invalid_input` if there are no features, or a number is not finite; names `what`.
void check_features(const std::string& what, const Eigen::MatrixXf& features);

/// See `features_of_parts()`. \pre each object has its columns
Eigen::MatrixXd integrated(const Surface_features& features, const Segmented_shape& objects, const Part_split& split);

} // namespace CGAL::Shape_correspondence::internal

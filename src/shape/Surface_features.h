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
  /// By object and triangle: the columns of its three vertices, or three times the column of the face.
  std::vector<Eigen::Matrix3Xi> columns;
};

/// Throws `Invalid_input` if there are no features, or one is not finite. \param what begins the message
void check_features(const std::string& what, const Eigen::MatrixXf& features);

/// The features of the parts, see `features_of_parts()`. \pre `features.columns` has an entry for each object
Eigen::MatrixXd integrated(const Surface_features& features, const Segmented_shape& objects, const Part_split& split);

} // namespace CGAL::Shape_correspondence::internal

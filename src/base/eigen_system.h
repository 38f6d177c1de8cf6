// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Points.h>

namespace CGAL::Shape_correspondence::internal {

/// Eigenvalues of a symmetric matrix, the least first, and their eigenvectors of length 1, a column each.
struct Eigen_system
{
  Eigen::Vector3d values;
  Eigen::Matrix3d vectors;
};

/// The eigenvalues and eigenvectors of a symmetric matrix, of which the lower triangle is read. Compiled once: Eigen's
/// solver is 2 s of compile time in every file that has one.
Eigen_system eigen_system(const Eigen::Matrix3d& symmetric);

/// Orthogonal eigenvectors of a symmetric matrix, that of the lesser eigenvalue first.
Eigen::Matrix2d eigenvectors(const Eigen::Matrix2d& symmetric);

/// The sum of p pᵀ over points p. Of few points, such as the samples of a part, without the detours that Eigen's
/// product makes for large matrices, to the same bits.
Eigen::Matrix3d scatter_matrix(const Points& points);

} // namespace CGAL::Shape_correspondence::internal

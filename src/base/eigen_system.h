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

/// The eigenvalues and eigenvectors of a symmetric matrix, of which the lower triangle is read. Apart from its callers,
/// since Eigen's solver is slow to compile.
Eigen_system eigen_system(const Eigen::Matrix3d& symmetric);

/// Orthogonal eigenvectors of a symmetric matrix, that of the lesser eigenvalue first.
Eigen::Matrix2d eigenvectors(const Eigen::Matrix2d& symmetric);

/// The sum of p pᵀ over points p, one after the other. Eigen's product of many points adds up blocks of them, whose
/// size depends on the processor's caches, and so would the last bits of results.
Eigen::Matrix3d scatter_matrix(const Points& points);

} // namespace CGAL::Shape_correspondence::internal

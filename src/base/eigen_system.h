// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Points.h>

namespace CGAL::Shape_correspondence::internal {

/// Eigenvalues of a symmetric matrix in ascending order, and unit eigenvectors as columns.
struct Eigen_system
{
  Eigen::Vector3d values;
  Eigen::Matrix3d vectors;
};

/// The eigenvalues and eigenvectors of a symmetric matrix, of which the lower triangle is read. Not inline, since
/// Eigen's solver is slow to compile.
Eigen_system eigen_system(const Eigen::Matrix3d& symmetric);

/// Orthonormal eigenvectors of a symmetric matrix as columns, that of the smaller eigenvalue first.
Eigen::Matrix2d eigenvectors(const Eigen::Matrix2d& symmetric);

/// The sum of p pᵀ over points p, added one after the other. Eigen's product adds many points in blocks whose size, and
/// thus the last bits of the result, depends on the processor's caches.
Eigen::Matrix3d scatter_matrix(const Points& points);

} // namespace CGAL::Shape_correspondence::internal

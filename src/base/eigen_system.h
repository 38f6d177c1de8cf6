// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_BASE_EIGEN_SYSTEM_H
#define CGAL_SHAPE_CORRESPONDENCE_BASE_EIGEN_SYSTEM_H

#include <CGAL/Shape_correspondence/Points.h>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

/// Eigenvalues of a symmetric matrix, the least first, and their eigenvectors of length 1, a column each.
struct Eigen_system
{
  Eigen::Vector3d values;
  Eigen::Matrix3d vectors;
};

/// The eigenvalues and eigenvectors of a symmetric matrix, of which the lower triangle is read. Compiled once: Eigen's
/// solver is 2 s of compile time in every file that has one.
Eigen_system eigen_system(const Eigen::Matrix3d& symmetric);

/// The sum of p pᵀ over points p.
Eigen::Matrix3d scatter_matrix(const Points& points);

} // namespace internal
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_BASE_EIGEN_SYSTEM_H

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/eigen_system.h"

#include <Eigen/Eigenvalues>

namespace CGAL::Shape_correspondence::internal {

Eigen_system eigen_system(const Eigen::Matrix3d& symmetric)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(symmetric);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

Eigen::Matrix2d eigenvectors(const Eigen::Matrix2d& symmetric)
{
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(symmetric).eigenvectors();
}

Eigen::Matrix3d scatter_matrix(const Points& points) { return points * points.transpose(); }

} // namespace CGAL::Shape_correspondence::internal

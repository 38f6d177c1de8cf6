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

Eigen::Matrix3d scatter_matrix(const Points& points)
{
  constexpr Eigen::Index fewest = 14; // number of points from which on Eigen adds them up in blocks
  if (points.cols() < fewest) return points * points.transpose();
  Eigen::Matrix3d result = Eigen::Matrix3d::Zero();
  for (Eigen::Index k = 0; k < points.cols(); ++k)
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i)
        result(i, j) += points(i, k) * points(j, k);
  return result;
}

} // namespace CGAL::Shape_correspondence::internal

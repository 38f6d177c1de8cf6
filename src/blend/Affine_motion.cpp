// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Affine_motion.h"

#include "base/eigen_system.h"

#include <Eigen/LU>
#include <Eigen/SparseCholesky>

#include <utility>

namespace CGAL::Shape_correspondence::internal {

Eigen::Affine3d Affine_motion::map() const
{
  Eigen::Affine3d result = Eigen::Affine3d::Identity();
  result.linear() += gradient;
  result.translation() = translation - gradient * middle;
  return result;
}

Affine_motion Affine_motion::symmetrised(const Affine_motion& other) const
{
  const Eigen::DiagonalMatrix<double, 3> mirror(-1, 1, 1);
  const Point at_image = mirror * middle;
  return {middle, (translation + mirror * other.displacement(at_image)) / 2,
          (gradient + mirror * other.gradient * mirror) / 2};
}

Affine_motion Affine_motion::bounded(double least_stretch, double most_stretch) const
{
  constexpr double invertible = 1e-6;
  Affine_motion result = *this;
  const Eigen::Matrix3d asked = Eigen::Matrix3d::Identity() + gradient;
  const Eigen_system system = eigen_system(asked.transpose() * asked);
  const Eigen::Vector3d stretches = system.values.cwiseMax(0).cwiseSqrt();
  const Eigen::Vector3d allowed = stretches.cwiseMax(least_stretch).cwiseMin(most_stretch);
  if (allowed == stretches) return result;
  result.gradient.setZero();
  if (stretches.minCoeff() > invertible && asked.determinant() > 0)
    result.gradient =
        asked * system.vectors * allowed.cwiseQuotient(stretches).asDiagonal() * system.vectors.transpose() -
        Eigen::Matrix3d::Identity();
  return result;
}

Affine_motion_solver::Affine_motion_solver(std::vector<Moving_body> bodies)
    : bodies_(std::move(bodies)), right_(Points::Zero(3, Eigen::Index(unknowns * bodies_.size())))
{
  constexpr double inertia = 0.005, stiffness = 0.02; // against 1, the weight of a contact
  for (std::size_t body = 0; body < bodies_.size(); ++body)
    add(body, body, Eigen::Vector4d(inertia, stiffness, stiffness, stiffness).asDiagonal());
}

void Affine_motion_solver::add_contact(std::size_t a, const Point& p, std::size_t b, const Point& q, double weight)
{
  const Eigen::Vector4d from = row(a, p), to = row(b, q);
  add(a, a, weight * from * from.transpose());
  add(b, b, weight * to * to.transpose());
  add(a, b, -weight * from * to.transpose());
  add(b, a, -weight * to * from.transpose());
  const Point step = weight * (q - p);
  right_.middleCols<unknowns>(index(a, 0)) += step * from.transpose();
  right_.middleCols<unknowns>(index(b, 0)) -= step * to.transpose();
}

std::vector<Affine_motion> Affine_motion_solver::solve() const
{
  Eigen::SparseMatrix<double> matrix(right_.cols(), right_.cols());
  matrix.setFromTriplets(entries_.begin(), entries_.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
  const Eigen::MatrixXd solution = solver.solve(right_.transpose()).transpose();
  std::vector<Affine_motion> result(bodies_.size());
  for (std::size_t body = 0; body < result.size(); ++body) {
    result[body].middle = bodies_[body].middle;
    result[body].translation = solution.col(index(body, 0));
    result[body].gradient = solution.middleCols<3>(index(body, 1)) / bodies_[body].size;
  }
  return result;
}

Eigen::Vector4d Affine_motion_solver::row(std::size_t body, const Point& p) const
{
  const Point off = (p - bodies_[body].middle) / bodies_[body].size;
  return {1, off[0], off[1], off[2]};
}

void Affine_motion_solver::add(std::size_t a, std::size_t b, const Eigen::Matrix4d& block)
{
  for (int i = 0; i < unknowns; ++i)
    for (int j = 0; j < unknowns; ++j)
      entries_.emplace_back(index(a, i), index(b, j), block(i, j));
}

} // namespace CGAL::Shape_correspondence::internal

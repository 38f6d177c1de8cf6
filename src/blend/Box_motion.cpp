// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Box_motion.h"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <utility>

namespace CGAL::Shape_correspondence::internal {

Eigen::Affine3d Box_motion::map() const
{
  Eigen::Affine3d result(stretch.asDiagonal());
  result.translation() = middle + translation - stretch.cwiseProduct(middle);
  return result;
}

Box_motion Box_motion::symmetrised(const Box_motion& other) const
{
  const Eigen::DiagonalMatrix<double, 3> mirror(-1, 1, 1);
  const Point at_image = mirror * middle, image = mirror * (other.map() * at_image - at_image);
  return {middle, (translation + image) / 2, (stretch + other.stretch) / 2};
}

Box_motion_solver::Box_motion_solver(std::vector<Moving_body> bodies)
    : bodies_(std::move(bodies)), right_(Points::Zero(3, Eigen::Index(unknowns * bodies_.size())))
{
  constexpr double inertia = 0.005, stiffness = 0.02; // against 1, the weight of a contact
  for (std::size_t body = 0; body < bodies_.size(); ++body)
    for (int axis = 0; axis < 3; ++axis)
      add(axis, body, body, Eigen::Vector2d(inertia, stiffness).asDiagonal().toDenseMatrix());
}

void Box_motion_solver::add_contact(std::size_t a, const Point& p, std::size_t b, const Point& q, double weight)
{
  for (int axis = 0; axis < 3; ++axis) {
    const auto row = [&](std::size_t body, const Point& at) {
      return Eigen::Vector2d(1, (at[axis] - bodies_[body].middle[axis]) / bodies_[body].size);
    };
    const Eigen::Vector2d from = row(a, p), to = row(b, q);
    add(axis, a, a, weight * from * from.transpose());
    add(axis, b, b, weight * to * to.transpose());
    add(axis, a, b, -weight * from * to.transpose());
    add(axis, b, a, -weight * to * from.transpose());
    const double step = weight * (q - p)[axis];
    right_.row(axis).segment<unknowns>(Eigen::Index(unknowns * a)) += step * from.transpose();
    right_.row(axis).segment<unknowns>(Eigen::Index(unknowns * b)) -= step * to.transpose();
  }
}

std::vector<Box_motion> Box_motion_solver::solve(double least_stretch, double most_stretch) const
{
  std::vector<Box_motion> result(bodies_.size());
  for (int axis = 0; axis < 3; ++axis) {
    const auto& entries = entries_[std::size_t(axis)];
    Eigen::SparseMatrix<double> matrix(right_.cols(), right_.cols());
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
    const Eigen::VectorXd solution = solver.solve(right_.row(axis).transpose());
    for (std::size_t body = 0; body < result.size(); ++body) {
      const auto at = Eigen::Index(unknowns * body);
      result[body].middle[axis] = bodies_[body].middle[axis];
      result[body].translation[axis] = solution[at];
      result[body].stretch[axis] = std::clamp(1 + solution[at + 1] / bodies_[body].size, least_stretch, most_stretch);
    }
  }
  return result;
}

void Box_motion_solver::add(int axis, std::size_t a, std::size_t b, const Eigen::Matrix2d& block)
{
  for (int i = 0; i < unknowns; ++i)
    for (int j = 0; j < unknowns; ++j)
      entries_[std::size_t(axis)].emplace_back(Eigen::Index(unknowns * a) + i, Eigen::Index(unknowns * b) + j,
                                               block(i, j));
}

} // namespace CGAL::Shape_correspondence::internal

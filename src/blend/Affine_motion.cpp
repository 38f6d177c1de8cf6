// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Affine_motion.h"

#include "base/eigen_system.h"

#include <Eigen/LU>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL::Shape_correspondence::internal {

void Affine_motion::apply(Points& points) const
{
  if (points.cols() > 0) points = (points + gradient * (points.colwise() - middle)).colwise() + translation;
}

Affine_motion Affine_motion::symmetrised(const Affine_motion& other) const
{
  const Eigen::DiagonalMatrix<double, 3> mirror(-1, 1, 1);
  const Point at_image = mirror * middle;
  return {middle, (translation + mirror * other.displacement(at_image)) / 2,
          (gradient + mirror * other.gradient * mirror) / 2};
}

Affine_motion Stretch::bounded(Affine_motion motion)
{
  const Eigen::Matrix3d asked = (Eigen::Matrix3d::Identity() + motion.gradient) * map_;
  const Eigen_system system = eigen_system(asked.transpose() * asked);
  const Eigen::Vector3d stretches = system.values.cwiseMax(0).cwiseSqrt();
  const Eigen::Vector3d allowed = stretches.cwiseMax(least_stretch).cwiseMin(most_stretch);
  if (allowed == stretches) {
    map_ = asked;
    return motion;
  }
  is_at_bound_ = true;
  Eigen::Matrix3d map = map_;
  constexpr double invertible = 1e-6;
  if (stretches.minCoeff() > invertible && asked.determinant() > 0)
    map = asked * system.vectors * allowed.cwiseQuotient(stretches).asDiagonal() * system.vectors.transpose();
  motion.gradient = map * map_.inverse() - Eigen::Matrix3d::Identity();
  map_ = map;
  return motion;
}

Affine_motion fitted_motion(const std::vector<Handle>& handles, double size)
{
  constexpr double stiffness = 0.1; // of the shape, over the squared size, against a handle's 1
  constexpr double regular = 1e-12; // so that what has no size can be solved for, too
  Affine_motion result;
  if (handles.empty()) return result;
  for (const Handle& handle : handles) {
    result.middle += handle.at / double(handles.size());
    result.translation += handle.displacement / double(handles.size());
  }
  Eigen::Matrix3d across = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d spread = (stiffness * size * size + regular) * Eigen::Matrix3d::Identity();
  for (const Handle& handle : handles) {
    across += (handle.displacement - result.translation) * (handle.at - result.middle).transpose();
    spread += (handle.at - result.middle) * (handle.at - result.middle).transpose();
  }
  result.gradient = across * spread.inverse();
  return result;
}

Affine_motion_solver::Affine_motion_solver(std::vector<Moving_body> bodies)
    : bodies_(std::move(bodies)), right_(Points::Zero(3, Eigen::Index(unknowns * bodies_.size())))
{
  constexpr double stiffness = 0.1; // of a body, against a contact's 1
  constexpr double rigid = 1e4;     // of one that is not to be stretched
  for (std::size_t body = 0; body < bodies_.size(); ++body)
    for (int i = 0; i < unknowns; ++i)
      add(all_, body, i, body, i, i == 0 ? bodies_[body].inertia : bodies_[body].is_rigid ? rigid : stiffness);
}

void Affine_motion_solver::add_contact(std::size_t a, const Point& p, std::size_t b, const Point& q, const Point& step)
{
  const Row from = row(a, p), to = row(b, q);
  for (int i = 0; i < unknowns; ++i) {
    for (int j = 0; j < unknowns; ++j) {
      add(all_, a, i, a, j, from[i] * from[j]);
      add(all_, b, i, b, j, to[i] * to[j]);
      add(all_, a, i, b, j, -from[i] * to[j]);
      add(all_, b, j, a, i, -from[i] * to[j]);
    }
    right_.col(index(a, i)) += from[i] * step;
    right_.col(index(b, i)) -= to[i] * step;
  }
}

void Affine_motion_solver::add_rise(std::size_t a, const Point& p, double step)
{
  const Row at = row(a, p);
  for (int i = 0; i < unknowns; ++i) {
    for (int j = 0; j < unknowns; ++j)
      add(upright_, a, i, a, j, at[i] * at[j]);
    right_(1, index(a, i)) += at[i] * step;
  }
}

std::vector<Affine_motion> Affine_motion_solver::solve()
{
  const Eigen::Index n = right_.cols();
  Eigen::SparseMatrix<double> matrix(n, n);
  matrix.setFromTriplets(all_.begin(), all_.end());
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
  Points solution(3, n);
  for (int axis : {0, 2})
    solution.row(axis) = solver.solve(right_.row(axis).transpose()).transpose();
  all_.insert(all_.end(), upright_.begin(), upright_.end());
  matrix.setFromTriplets(all_.begin(), all_.end());
  solver.compute(matrix);
  solution.row(1) = solver.solve(right_.row(1).transpose()).transpose();
  std::vector<Affine_motion> result(bodies_.size());
  for (std::size_t body = 0; body < result.size(); ++body) {
    result[body].middle = bodies_[body].middle;
    result[body].translation = solution.col(index(body, 0));
    result[body].gradient = solution.middleCols(index(body, 1), 3) / bodies_[body].size;
  }
  return result;
}

Affine_motion_solver::Row Affine_motion_solver::row(std::size_t body, const Point& p) const
{
  const Point off = (p - bodies_[body].middle) / bodies_[body].size;
  return {1, off[0], off[1], off[2]};
}

void Affine_motion_solver::add(Entries& entries, std::size_t a, int i, std::size_t b, int j, double value) const
{
  entries.emplace_back(index(a, i), index(b, j), value);
}

} // namespace CGAL::Shape_correspondence::internal

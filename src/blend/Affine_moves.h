// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_BLEND_AFFINE_MOVES_H
#define CGAL_SHAPE_CORRESPONDENCE_BLEND_AFFINE_MOVES_H

#include <CGAL/Shape_correspondence/Points.h>

#include <Eigen/SparseCholesky>

#include <array>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

/// Moves every point by a shift that changes linearly with its place.
struct Affine_move
{
  Point middle = Point::Zero(), shift = Point::Zero();
  Eigen::Matrix3d gradient = Eigen::Matrix3d::Zero();

  Point of(const Point& p) const { return shift + gradient * (p - middle); }

  void apply(Points& points) const
  {
    if (points.cols() > 0) points = (points + gradient * (points.colwise() - middle)).colwise() + shift;
  }

  /// The mean with the mirror image, in x = 0, of another move.
  Affine_move symmetrised(const Affine_move& other) const
  {
    const Eigen::DiagonalMatrix<double, 3> mirror(-1, 1, 1);
    const Point at_image = mirror * middle;
    return {middle, (shift + mirror * other.of(at_image)) / 2, (gradient + mirror * other.gradient * mirror) / 2};
  }
};

/// What is to be moved.
struct Movable_body
{
  Point middle = Point::Zero();
  double size = 1;    ///< a change of shape counts as much as a motion this far from the middle; not 0
  double inertia = 1; ///< how much it resists being moved
};

/// Finds the affine moves of bodies by which pulls between them are met best, in the least squares sense, with little
/// motion, of small bodies rather than of large ones, and little change of shape.
class Affine_moves
{
public:
  explicit Affine_moves(std::vector<Movable_body> bodies)
      : bodies_(std::move(bodies)), right_(Points::Zero(3, Eigen::Index(size * bodies_.size())))
  {
    for (std::size_t body = 0; body < bodies_.size(); ++body)
      for (int i = 0; i < size; ++i)
        add(all_, body, i, body, i, i == 0 ? bodies_[body].inertia : stiffness);
  }

  /// Asks that `p` on body `a` and `q` on body `b` come nearer to each other by the step from p to q.
  void pull(std::size_t a, const Point& p, std::size_t b, const Point& q, const Point& step)
  {
    const Row from = row(a, p), to = row(b, q);
    for (int i = 0; i < size; ++i) {
      for (int j = 0; j < size; ++j) {
        add(all_, a, i, a, j, from[i] * from[j]);
        add(all_, b, i, b, j, to[i] * to[j]);
        add(all_, a, i, b, j, -from[i] * to[j]);
        add(all_, b, j, a, i, -from[i] * to[j]);
      }
      right_.col(index(a, i)) += from[i] * step;
      right_.col(index(b, i)) -= to[i] * step;
    }
  }

  /// Asks that `p` on a body rises by a step.
  void lift(std::size_t a, const Point& p, double step)
  {
    const Row at = row(a, p);
    for (int i = 0; i < size; ++i) {
      for (int j = 0; j < size; ++j)
        add(upright_, a, i, a, j, at[i] * at[j]);
      right_(1, index(a, i)) += at[i] * step;
    }
  }

  /// The moves, by body.
  std::vector<Affine_move> solve()
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
    std::vector<Affine_move> result(bodies_.size());
    for (std::size_t body = 0; body < result.size(); ++body) {
      result[body].middle = bodies_[body].middle;
      result[body].shift = solution.col(index(body, 0));
      result[body].gradient = solution.middleCols(index(body, 1), 3) / bodies_[body].size;
    }
    return result;
  }

private:
  static constexpr int size = 4;           // unknowns of a body and coordinate: the shift, and its gradient
  static constexpr double stiffness = 0.1; // of a body, against a pull of 1
  using Row = std::array<double, size>;

  Eigen::Index index(std::size_t body, int i) const { return Eigen::Index(size * body) + i; }

  Row row(std::size_t body, const Point& p) const
  {
    const Point off = (p - bodies_[body].middle) / bodies_[body].size;
    return {1, off[0], off[1], off[2]};
  }

  void add(std::vector<Eigen::Triplet<double>>& entries, std::size_t a, int i, std::size_t b, int j, double value)
  {
    entries.emplace_back(index(a, i), index(b, j), value);
  }

  std::vector<Movable_body> bodies_;
  std::vector<Eigen::Triplet<double>> all_, upright_; // of the normal equations; the latter of the y coordinate only
  Points right_;
};

} // namespace internal
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_BLEND_AFFINE_MOVES_H

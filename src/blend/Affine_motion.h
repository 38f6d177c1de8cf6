// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Points.h>

#include <Eigen/SparseCore>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// Moves every point by a translation that changes linearly with its place.
struct Affine_motion
{
  Point middle = Point::Zero(), translation = Point::Zero(); ///< the latter of the former
  Eigen::Matrix3d gradient = Eigen::Matrix3d::Zero();

  /// How far a point is moved.
  Point displacement(const Point& p) const { return translation + gradient * (p - middle); }

  bool is_none() const { return translation.isZero(0) && gradient.isZero(0); }
  void apply(Points& points) const;

  /// The mean with the mirror image, in x = 0, of another motion.
  Affine_motion symmetrised(const Affine_motion& other) const;
};

/// What motions that close gaps may do to the shape of a part, all of them together: singular values of the linear map.
/// What is stretched more looks like another part, what is compressed more looks crushed.
constexpr double least_stretch = 0.7, most_stretch = 1.4;

/// How a part has been stretched by motions so far.
class Stretch
{
public:
  /// The motion as far as the part may still be stretched; what is beyond, it is not, and goes with its middle.
  Affine_motion bounded(Affine_motion motion);

  /// Whether a motion has been beyond the bounds.
  bool is_at_bound() const { return is_at_bound_; }

private:
  Eigen::Matrix3d map_ = Eigen::Matrix3d::Identity();
  bool is_at_bound_ = false;
};

/// A point of what is deformed, and by how much it is to move.
struct Handle
{
  Point at, displacement;
};

/// The affine motion nearest to what handles ask for, in the least squares sense, that changes the shape little where
/// they do not ask for it.
/// \param size of what is moved
Affine_motion fitted_motion(const std::vector<Handle>& handles, double size);

/// What a contact pulls at: a part, as a body with an affine motion.
struct Moving_body
{
  Point middle = Point::Zero();
  double size = 1;       ///< a change of shape counts as much as a motion this far from the middle; not 0
  double inertia = 1;    ///< how much it resists being moved
  bool is_rigid = false; ///< it is to be moved without a change of shape
};

/// Finds the affine motions of bodies that close the gaps of their contacts best, in the least squares sense, with
/// little motion, of small bodies rather than of large ones, and little change of shape.
class Affine_motion_solver
{
public:
  explicit Affine_motion_solver(std::vector<Moving_body> bodies);

  /// Asks that `p` on body `a` and `q` on body `b` come nearer to each other by the step from p to q.
  void add_contact(std::size_t a, const Point& p, std::size_t b, const Point& q, const Point& step);

  /// Asks that `p` on a body rises by a step.
  void add_rise(std::size_t a, const Point& p, double step);

  /// The motions, by body.
  std::vector<Affine_motion> solve();

private:
  using Entries = std::vector<Eigen::Triplet<double>>;
  static constexpr int unknowns = 4; // of a body and coordinate: the translation, and its gradient
  using Row = std::array<double, unknowns>;

  Eigen::Index index(std::size_t body, int i) const { return Eigen::Index(unknowns * body) + i; }
  Row row(std::size_t body, const Point& p) const;
  void add(Entries& entries, std::size_t a, int i, std::size_t b, int j, double value) const;

  std::vector<Moving_body> bodies_;
  Entries all_, upright_; // of the normal equations; the latter of the y coordinate only
  Points right_;
};

} // namespace CGAL::Shape_correspondence::internal

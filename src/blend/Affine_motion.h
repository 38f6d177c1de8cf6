// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Points.h>

#include <Eigen/Geometry>
#include <Eigen/SparseCore>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// Moves every point by a translation that changes linearly with its place.
struct Affine_motion
{
  Point middle = Point::Zero(), translation = Point::Zero(); ///< of the latter, that of the former
  Eigen::Matrix3d gradient = Eigen::Matrix3d::Zero();

  /// How far a point is moved.
  Point displacement(const Point& p) const { return translation + gradient * (p - middle); }
  /// The map from points to where they are moved.
  Eigen::Affine3d map() const;
  /// The mean with the mirror image, in x = 0, of another motion.
  Affine_motion symmetrised(const Affine_motion& other) const;
  /// The motion without what stretches by more or less than factors: what is stretched more looks like another part,
  /// what is compressed more looks crushed.
  Affine_motion bounded(double least_stretch, double most_stretch) const;
};

/// A part as a body with an affine motion.
struct Moving_body
{
  Point middle = Point::Zero();
  double size = 1; ///< a change of shape counts as much as a motion this far from the middle; not 0
};

/// Finds the affine motions of bodies that close the gaps of their contacts, in the least squares sense, with as little
/// motion and change of shape as that takes.
class Affine_motion_solver
{
public:
  explicit Affine_motion_solver(std::vector<Moving_body> bodies);

  /// Asks that `p` on body `a` and `q` on body `b` come to one place.
  void add_contact(std::size_t a, const Point& p, std::size_t b, const Point& q, double weight);

  /// The motions, by body.
  std::vector<Affine_motion> solve() const;

private:
  static constexpr int unknowns = 4; // of a body and coordinate: the translation, and its gradient

  Eigen::Index index(std::size_t body, int i) const { return Eigen::Index(unknowns * body) + i; }
  Eigen::Vector4d row(std::size_t body, const Point& p) const;
  void add(std::size_t a, std::size_t b, const Eigen::Matrix4d& block);

  std::vector<Moving_body> bodies_;
  std::vector<Eigen::Triplet<double>> entries_; // of the normal equations, which are those of every coordinate
  Points right_;
};

} // namespace CGAL::Shape_correspondence::internal

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

/// Moves a body and stretches it along the axes. It does not turn or shear: what is upright stays upright.
struct Box_motion
{
  Point middle = Point::Zero(), translation = Point::Zero(); ///< of the latter, that of the former
  Point stretch = Point::Ones();                             ///< by axis

  /// The map from points to where they are moved.
  Eigen::Affine3d map() const;
  /// The mean with the mirror image, in x = 0, of another motion.
  Box_motion symmetrised(const Box_motion& other) const;
};

/// A part as a body that moves.
struct Moving_body
{
  Point middle = Point::Zero();
  double size = 1; ///< a change of shape counts as much as a motion this far from the middle; not 0
};

/// Finds the motions of bodies that close the gaps of their contacts, in the least squares sense, with as little motion
/// and change of shape as that takes. What goes on along one axis has no part in what goes on along another one.
class Box_motion_solver
{
public:
  explicit Box_motion_solver(std::vector<Moving_body> bodies);

  /// Asks that `p` on body `a` and `q` on body `b` come to one place.
  void add_contact(std::size_t a, const Point& p, std::size_t b, const Point& q, double weight);

  /// The motions, by body. Stretches are bounded: what is stretched more looks like another part, what is compressed
  /// more looks crushed.
  std::vector<Box_motion> solve(double least_stretch, double most_stretch) const;

private:
  static constexpr int unknowns = 2; // of a body and axis: the translation, and what the stretch adds

  void add(int axis, std::size_t a, std::size_t b, const Eigen::Matrix2d& block);

  std::vector<Moving_body> bodies_;
  std::array<std::vector<Eigen::Triplet<double>>, 3> entries_; // of the normal equations, by axis
  Points right_;
};

} // namespace CGAL::Shape_correspondence::internal

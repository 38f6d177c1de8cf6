// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <Eigen/Core>

#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// A part without counterpart, which draws back into what carries it, or grows out of it in reverse: a leg into the
/// seat along its length, a cushion across, a wheel into its hub as a whole. Its roots, where it is carried, stay. When
/// little remains, it shrinks in all directions. A rod that is carried at both ends becomes thin.
class Retreating_part
{
public:
  /// \param axes of the part's box, a rotation
  /// \param roots where it is carried
  Retreating_part(const Part_mesh& mesh, const Eigen::Matrix3d& axes, const std::vector<Point>& roots);

  const Eigen::Matrix3Xi& triangles() const { return mesh_.triangles; }
  /// The middle of those of its roots that it draws back to.
  const Point& root() const { return root_; }

  /// Where a point of the part is when a share of its extent remains, in [0, 1].
  Point place(const Point& p, double remaining) const;
  Points points(double remaining) const;

private:
  Eigen::Matrix3d scale(double remaining) const;

  Part_mesh mesh_;
  Point root_;
  Eigen::Matrix3d vanishing_ = Eigen::Matrix3d::Identity(); ///< projection onto the axes along which it vanishes first
};

} // namespace CGAL::Shape_correspondence::internal

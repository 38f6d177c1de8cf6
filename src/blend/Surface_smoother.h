// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Points.h>

#include <Eigen/SparseCore>

#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// Smooths vectors at the points of a surface, by linear elements. Separate components are smoothed each by itself.
class Surface_smoother
{
public:
  Surface_smoother(const Points& surface, const Eigen::Matrix3Xi& triangles);

  /// Vectors smoothed over about a length: w that minimises the integral of |w - given|² + length² |grad w|² over the
  /// surface.
  Points operator()(const Points& given, double length) const;

private:
  std::vector<int> places_; ///< `first_in_place()`
  Eigen::VectorXd areas_;   ///< by point
  Eigen::SparseMatrix<double> stiffness_;
};

} // namespace CGAL::Shape_correspondence::internal

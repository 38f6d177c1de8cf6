// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "shape/first_in_place.h"

#include <CGAL/Shape_correspondence/Points.h>

#include <CGAL/assertions.h>

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// Smooths vectors at the points of a surface with linear finite elements. Connected components are independent.
class Surface_smoother
{
public:
  Surface_smoother(const Points& surface, const Eigen::Matrix3Xi& triangles);

  /// The smoothed vectors w, which minimize the integral of |w - given|² + length² |grad w|² over the surface.
  Points operator()(const Points& given, double length) const;

private:
  std::vector<int> places_; ///< result of `first_in_place()`
  Eigen::VectorXd areas_;   ///< indexed by point
  Eigen::SparseMatrix<double> stiffness_;
};

inline Surface_smoother::Surface_smoother(const Points& surface, const Eigen::Matrix3Xi& triangles)
    : places_(first_in_place(surface)), areas_(surface.cols()), stiffness_(surface.cols(), surface.cols())
{
  constexpr double least_area = 1e-9; // lets points without triangles keep their vectors
  constexpr double flattest = 1e-4;   // least height over base of a triangle; flatter triangles count as that
  areas_.setConstant(least_area);
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < int(surface.cols()); ++i)
    entries.emplace_back(i, i, 0); // makes every diagonal entry exist
  for (Eigen::Index t = 0; t < triangles.cols(); ++t) {
    const auto place = [&](int corner) { return places_[std::size_t(triangles(corner % 3, t))]; };
    const auto side = [&](int from) -> Point { return surface.col(place(from + 1)) - surface.col(place(from)); };
    const double longest = std::max({side(0).squaredNorm(), side(1).squaredNorm(), side(2).squaredNorm()});
    if (!(longest > 0)) continue; // the triangle is a point
    const double doubled_area = std::max(side(0).cross(side(1)).norm(), flattest * longest);
    for (int corner = 0; corner < 3; ++corner) {
      const int a = place(corner + 1), b = place(corner + 2);
      const double weight = -side(corner).dot(side(corner + 2)) / doubled_area / 2; // half of the cotangent
      areas_[place(corner)] += doubled_area / 6;
      entries.insert(entries.end(), {{a, a, weight}, {b, b, weight}, {a, b, -weight}, {b, a, -weight}});
    }
  }
  stiffness_.setFromTriplets(entries.begin(), entries.end());
}

inline Points Surface_smoother::operator()(const Points& given, double length) const
{
  Eigen::SparseMatrix<double> system = length * length * stiffness_;
  system.diagonal() += areas_;
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(system);
  CGAL_assertion(solver.info() == Eigen::Success); // the system is positive definite
  // Solves for the change, from differences: constants are kept exactly, even on slivers
  Eigen::MatrixX3d due = Eigen::MatrixX3d::Zero(given.cols(), 3);
  for (int i = 0; i < int(given.cols()); ++i)
    for (Eigen::SparseMatrix<double>::InnerIterator entry(stiffness_, i); entry; ++entry)
      due.row(i) += length * length * entry.value() * (given.col(i) - given.col(entry.row())).transpose();
  const Eigen::MatrixX3d change = solver.solve(due);
  Points result(3, given.cols());
  for (Eigen::Index i = 0; i < result.cols(); ++i)
    result.col(i) = given.col(places_[std::size_t(i)]) + change.row(places_[std::size_t(i)]).transpose();
  return result;
}

} // namespace CGAL::Shape_correspondence::internal

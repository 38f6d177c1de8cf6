// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/smoothed.h"

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <array>
#include <map>

namespace CGAL::Shape_correspondence::internal {

std::vector<int> first_in_place(const Points& points)
{
  std::map<std::array<double, 3>, int> first;
  std::vector<int> result;
  for (int i = 0; i < int(points.cols()); ++i)
    result.push_back(first.emplace(std::array<double, 3>{points(0, i), points(1, i), points(2, i)}, i).first->second);
  return result;
}

Points smoothed(const Points& given, const Points& surface, const Eigen::Matrix3Xi& triangles, double length)
{
  constexpr double least_area = 1e-9; // of flat triangles, and of points without any
  const std::vector<int> places = first_in_place(surface);
  const Eigen::Index count = surface.cols();
  Eigen::VectorXd areas = Eigen::VectorXd::Constant(count, least_area); // by point
  std::vector<Eigen::Triplet<double>> entries;
  for (Eigen::Index t = 0; t < triangles.cols(); ++t) {
    const auto place = [&](int corner) { return places[std::size_t(triangles(corner % 3, t))]; };
    for (int corner = 0; corner < 3; ++corner) {
      const int a = place(corner + 1), b = place(corner + 2);
      const Point at = surface.col(place(corner)), to_a = surface.col(a) - at, to_b = surface.col(b) - at;
      const double doubled = std::max(to_a.cross(to_b).norm(), least_area);
      areas[place(corner)] += doubled / 6;
      const double weight = length * length * to_a.dot(to_b) / doubled / 2; // half the cotangent
      entries.insert(entries.end(), {{a, a, weight}, {b, b, weight}, {a, b, -weight}, {b, a, -weight}});
    }
  }
  for (int i = 0; i < int(count); ++i)
    entries.emplace_back(i, i, areas[i]);
  Eigen::SparseMatrix<double> system(count, count);
  system.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(system);
  const Eigen::MatrixX3d solved = solver.solve(Eigen::MatrixX3d(areas.asDiagonal() * given.transpose()));
  Points result(3, count);
  for (Eigen::Index i = 0; i < count; ++i)
    result.col(i) = solved.row(places[std::size_t(i)]).transpose();
  return result;
}

} // namespace CGAL::Shape_correspondence::internal

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Shape_correspondence/topological_medoid.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <vector>

using namespace CGAL::Shape_correspondence;

namespace {

Eigen::MatrixXd distances_of(const std::vector<double>& places)
{
  const auto n = Eigen::Index(places.size());
  return Eigen::MatrixXd::NullaryExpr(
      n, n, [&](Eigen::Index i, Eigen::Index j) { return std::abs(places[std::size_t(i)] - places[std::size_t(j)]); });
}

} // namespace

TEST_CASE("The medoid of points on a line is the median")
{
  CHECK(topological_medoid(distances_of({9, 1, 4, 3, 20})) == 2);
  CHECK(topological_medoid(distances_of({5})) == 0);
  CHECK(topological_medoid(distances_of({1, 2})) == 0); // the first one in case of a tie
  CHECK(topological_medoid(distances_of({7, 3, 4, 3})) == 1);
}

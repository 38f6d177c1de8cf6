// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/Nearest_points.h"
#include "matching/nearest_points_kernel.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

using namespace CGAL::Shape_correspondence;

TEST_CASE("Vector instructions find the nearest points of a plain loop, to the bit")
{
  std::srand(7);
  for (const int n : {1, 6, 37})
    for (const int m : {1, 8, 36}) {
      const Eigen::ArrayX3d a = Eigen::ArrayX3d::Random(n, 3), b = Eigen::ArrayX3d::Random(m, 3);
      Eigen::ArrayXXd squared(n, m);
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < m; ++j) {
          const double x = b(j, 0) - a(i, 0), y = b(j, 1) - a(i, 1), z = b(j, 2) - a(i, 2);
          squared(i, j) = x * x + y * y + z * z;
        }
      const internal::Point_lanes p(a), q(b);
      CAPTURE(n, m);
      Eigen::ArrayXd p_from_q(p.padded()), q_from_p(q.padded());
      internal::find_nearest(p, q, p_from_q.data(), q_from_p.data());
      CHECK((p_from_q.head(n) == squared.rowwise().minCoeff().sqrt()).all());
      CHECK((q_from_p.head(m) == squared.colwise().minCoeff().transpose().sqrt()).all());
    }
}

TEST_CASE("Of several nearest points, the tree of points finds the first")
{
  const int n = 6; // number of grid points along an axis; every point occurs twice
  Points grid(3, 2 * n * n * n);
  for (int i = 0; i < n * n * n; ++i) {
    grid.col(i) = Point(i / (n * n), i / n % n, i % n);
    grid.col(n * n * n + i) = grid.col(i);
  }
  grid.rowwise().reverseInPlace(); // an order that is not that of the tree
  const internal::Nearest_points tree(grid);
  for (int i = 0; i < grid.cols(); ++i) {
    const Point query = grid.col(i) + 0.5 * Point(i % 2, i / 2 % 2, i / 4 % 2);
    const Eigen::VectorXd squared = (grid.colwise() - query).colwise().squaredNorm();
    const Eigen::Index first = std::min_element(squared.begin(), squared.end()) - squared.begin();
    CHECK(std::sqrt(squared[first]) == tree.distance(query));
    CHECK(tree.nearest_within(query, n) == first);
    const Eigen::Index second = tree.nearest_within(query, n, first);
    REQUIRE(second > first);
    CHECK(squared[second] == squared[first]);
  }
}

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/eigen_system.h"

#include <catch2/catch.hpp>

#include <random>

using namespace CGAL::Shape_correspondence;

TEST_CASE("Scatter of points is the product of their matrix with its transpose, however many they are")
{
  std::mt19937 random(3);
  for (Eigen::Index n : {1, 2, 5, 13, 14, 15, 31, 32, 64, 127, 128, 129, 200}) {
    const Points points = Points::NullaryExpr(
        3, n, [&](Eigen::Index, Eigen::Index) { return double(random()) / double(std::mt19937::max()) - 0.5; });
    INFO(n);
    CHECK(internal::scatter_matrix(points) == Eigen::Matrix3d(points * points.transpose()));
  }
}

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/eigen_system.h"

#include <catch2/catch.hpp>

#include <random>

using namespace CGAL::Shape_correspondence;

namespace {

Points random_points(Eigen::Index number)
{
  std::mt19937 random(3);
  return Points::NullaryExpr(
      3, number, [&](Eigen::Index, Eigen::Index) { return double(random()) / double(std::mt19937::max()) - 0.5; });
}

} // namespace

TEST_CASE("Scatter of points is the product of their matrix with its transpose, however many they are")
{
  for (Eigen::Index n : {1, 2, 5, 13, 14, 15, 31, 32, 64, 127, 128, 129, 200}) {
    const Points points = random_points(n);
    INFO(n);
    CHECK(internal::scatter_matrix(points) == Eigen::Matrix3d(points * points.transpose()));
  }
}

TEST_CASE("Scatter of many points does not depend on the caches of the processor")
{
  constexpr int kilobyte = 1 << 10;
  const Points points = random_points(5000);
  const std::ptrdiff_t l1 = Eigen::l1CacheSize(), l2 = Eigen::l2CacheSize(), l3 = Eigen::l3CacheSize();
  const Eigen::Matrix3d scatter = internal::scatter_matrix(points);
  for (int size : {16, 32, 48, 64}) {
    INFO(size);
    Eigen::setCpuCacheSizes(size * kilobyte, 8 * size * kilobyte, 64 * size * kilobyte);
    CHECK(internal::scatter_matrix(points) == scatter);
  }
  Eigen::setCpuCacheSizes(l1, l2, l3);
}

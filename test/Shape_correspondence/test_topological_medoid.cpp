// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/topological_medoid.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <vector>

using namespace CGAL::Shape_correspondence;

namespace {

Eigen::MatrixXd distances_of(const std::vector<double>& places)
{
  const auto n = Eigen::Index(places.size());
  return Eigen::MatrixXd::NullaryExpr(
      n, n, [&](Eigen::Index i, Eigen::Index j) { return std::abs(places[std::size_t(i)] - places[std::size_t(j)]); });
}

// Points in the plane, or distances that obey no triangle inequality, some of them ties.
Eigen::MatrixXd random_distances(Eigen::Index n, bool metric, unsigned seed)
{
  std::mt19937 random(seed);
  const auto unit = [&] { return double(random() % 64) / 64; };
  const Eigen::Matrix2Xd points = Eigen::Matrix2Xd::NullaryExpr(2, n, unit);
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < i; ++j)
      result(i, j) = result(j, i) = metric ? (points.col(i) - points.col(j)).norm() : unit();
  return result;
}

} // namespace

TEST_CASE("The medoid of points on a line is the median")
{
  CHECK(topological_medoid(distances_of({9, 1, 4, 3, 20})) == 2);
  CHECK(topological_medoid(distances_of({5})) == 0);
  CHECK(topological_medoid(distances_of({1, 2})) == 0); // a tie: the first
  CHECK(topological_medoid(distances_of({7, 3, 4, 3})) == 1);
}

TEST_CASE("Sampling finds the medoid on every set, and asks for every distance once at most")
{
  for (bool metric : {true, false})
    for (unsigned seed = 0; seed < 40; ++seed) {
      const Eigen::Index n = 1 + Eigen::Index(seed) * 3;
      const Eigen::MatrixXd distances = random_distances(n, metric, seed);
      std::set<std::pair<std::size_t, std::size_t>> asked;
      Sampled_medoid_options options;
      options.seed = seed;
      const Sampled_medoid found = sampled_medoid(
          std::size_t(n),
          [&](std::size_t i, std::size_t j) {
            CHECK(i < j);
            CHECK(asked.emplace(i, j).second);
            return distances(Eigen::Index(i), Eigen::Index(j));
          },
          options);
      CHECK(found.shape == topological_medoid(distances));
      CHECK(found.evaluations == asked.size());
      CHECK(found.mean_distance ==
            Approx(distances.row(Eigen::Index(found.shape)).sum() / double(std::max<Eigen::Index>(1, n - 1))));
    }
}

TEST_CASE("Sampling spares distances: some with certainty, most with a chance of failure")
{
  // One shape in the middle of many others
  const Eigen::Index n = 1000;
  std::mt19937 random(1);
  const auto bell = [&] { return double(random() % 1000 + random() % 1000 + random() % 1000) / 1000 - 1.5; };
  Eigen::Matrix2Xd points = Eigen::Matrix2Xd::NullaryExpr(2, n, bell);
  points.rightCols(n / 2) *= 4;
  points.col(123).setZero();
  const auto distance = [&](std::size_t i, std::size_t j) {
    return (points.col(Eigen::Index(i)) - points.col(Eigen::Index(j))).norm();
  };
  const auto all = std::size_t(n * (n - 1) / 2);
  const Sampled_medoid certain = sampled_medoid(std::size_t(n), distance);
  CHECK(certain.shape == 123);
  CHECK(certain.evaluations < all);
  Sampled_medoid_options options;
  options.failure_probability = 1e-3;
  const Sampled_medoid probable = sampled_medoid(std::size_t(n), distance, options);
  CHECK(probable.shape == 123);
  CHECK(probable.evaluations < all / 2);
}

TEST_CASE("Distances and options that cannot be used are refused")
{
  const auto constant = [](double d) { return [d](std::size_t, std::size_t) { return d; }; };
  CHECK_THROWS_AS(sampled_medoid(3, constant(-1)), Invalid_input);
  CHECK_THROWS_AS(sampled_medoid(3, constant(std::nan(""))), Invalid_input);
  CHECK_THROWS_AS(sampled_medoid(3, constant(std::numeric_limits<double>::infinity())), Invalid_input);
  Sampled_medoid_options options;
  options.failure_probability = 1;
  CHECK_THROWS_AS(sampled_medoid(3, constant(1), options), Invalid_input);
  options = {};
  options.batch = 0;
  CHECK_THROWS_AS(sampled_medoid(3, constant(1), options), Invalid_input);
}

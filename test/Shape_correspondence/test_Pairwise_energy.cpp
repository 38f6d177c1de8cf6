// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Shape_correspondence/Pairwise_energy.h>

#include <catch2/catch.hpp>

#include <cmath>

using namespace CGAL::Shape_correspondence;

namespace {

// Two variables with two labels each, an edge and a root term.
Pairwise_energy small_energy()
{
  Pairwise_energy energy;
  energy.unary = {Eigen::Vector2d(1, 2), Eigen::Vector2d(0, 4)};
  energy.edges = {{0, 1, (Eigen::Matrix2d() << 5, 0, 3, 7).finished()}};
  energy.root_terms = {{2, 2, {Eigen::Vector2d(1, 0.25), Eigen::Vector2d(1, 0)}, {}}};
  return energy;
}

} // namespace

TEST_CASE("The energy is the sum of its terms, worked out by hand")
{
  const Pairwise_energy energy = small_energy();
  CHECK(energy.number_of_variables() == 2);
  CHECK(energy.number_of_labels(1) == 2);
  CHECK(energy({0, 0}) == 1 + 0 + 5);                                      // `root_sum()` Q = 2: the root term is 0
  CHECK(energy({0, 1}) == Approx(1 + 4 + 0 + 2 * (1 - std::sqrt(0.5))));   // Q = 1
  CHECK(energy({1, 0}) == Approx(2 + 0 + 3 + 2 * (1 - std::sqrt(0.625)))); // Q = 1.25
  CHECK(energy.root_sum(energy.root_terms[0], {1, 1}) == 0.25);
}

TEST_CASE("The lower bound adds up the least values of all terms")
{
  const Pairwise_energy energy = small_energy();
  CHECK(energy.lower_bound() == 1 + 0 + 0 + 0);
  for (int a : {0, 1})
    for (int b : {0, 1})
      CHECK(energy.lower_bound() <= energy({a, b}));
}

TEST_CASE("Root terms may have shares of pairs of labels")
{
  Pairwise_energy energy = small_energy();
  energy.root_terms[0].count = 4;
  energy.root_terms[0].edge = {(Eigen::Matrix2d() << 2, 0, 0, 0).finished()};
  CHECK(energy.root_sum(energy.root_terms[0], {0, 0}) == 4);
  CHECK(energy({0, 0}) == 6);
}

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "random_tables.h"
#include "search/Tangents.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <random>
#include <vector>

using namespace CGAL::Shape_correspondence;

namespace {

// Checks the lower bounds for all completions of the first `level` labels. \return the least tangent value among them
template <typename Check_leaf>
double check_bounds(const internal::Tangent_bound& tangent, bool exact, std::size_t level, double cost,
                    std::vector<int>& labels, const Check_leaf& check_leaf)
{
  if (level == labels.size()) {
    check_leaf(cost);
    return cost;
  }
  std::array<double, 3> costs, bounds;
  tangent.tables.extend(level, labels, cost, costs.data(), bounds.data());
  double least = std::numeric_limits<double>::infinity();
  for (int l = 0; l < 3; ++l) {
    labels[level] = l;
    const double below = check_bounds(tangent, exact, level + 1, costs[l], labels, check_leaf);
    CHECK(bounds[l] <= below + 1e-9);
    if (exact) CHECK(bounds[l] == Approx(below).margin(1e-9));
    least = std::min(least, below);
  }
  return least;
}

} // namespace

TEST_CASE("Bounds by tangents: never above the energy, equal to it where they touch; exact unless buckets are split")
{
  std::mt19937 random(11);
  for (const std::size_t table_limit : {27, 9}) {
    const Pairwise_energy energy = random_tables(random, 5, 3, 2);
    const std::vector<std::size_t> order = internal::elimination_order(energy);
    const Assignment touched{2, 0, 1, 2, 1};
    internal::Tangents tangents(energy, order, table_limit);
    const bool exact = table_limit == 27;
    CHECK(tangents.exact() == exact);
    internal::Tangent_bound tangent = tangents.make();
    tangents.touch({energy.root_sum(energy.root_terms[0], touched)}, tangent);

    std::vector<int> labels(5);
    const double least = check_bounds(tangent, exact, 0, tangent.offset, labels, [&](double cost) {
      Assignment assignment(5);
      for (std::size_t i = 0; i < 5; ++i)
        assignment[order[i]] = labels[i];
      CHECK(cost <= energy(assignment) + 1e-9);
      if (assignment == touched) CHECK(cost == Approx(energy(assignment)));
    });
    CHECK(tangent.bound() <= least + 1e-9);
    if (exact) CHECK(tangent.bound() == Approx(least).margin(1e-9));
  }
}

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Shape_correspondence/beam_search.h>
#include <CGAL/Shape_correspondence/exact_search.h>

#include "brute_force.h"
#include "hand_made_graphs.h"

#include <catch2/catch.hpp>

#include <random>

using namespace CGAL::Shape_correspondence;
using namespace hand_made;

namespace {

// Random curves and sheets, random contacts, random groups of one or two parts with random solidity.
Structural_graph random_graph(std::mt19937& random, std::size_t group_count)
{
  std::uniform_real_distribution<double> unit(0, 1);
  const auto point = [&] { return Point(unit(random) - .5, unit(random), unit(random) - .5); };
  Shape_structure shape;
  std::vector<Part_group> groups;
  for (std::size_t g = 0; g < group_count; ++g) {
    std::vector<std::size_t> members;
    for (int i = unit(random) < .5 ? 0 : 1; i < 2; ++i) {
      members.push_back(shape.parts.size());
      const std::string name = std::to_string(shape.parts.size());
      if (unit(random) < .7)
        shape.parts.push_back(curve(name, point(), point()));
      else
        shape.parts.push_back(sheet(name, point(), point(), point()));
    }
    groups.push_back(group(members, Symmetry_type::TRANSLATION, Point::UnitX(), .1 + .9 * unit(random)));
  }
  for (std::size_t a = 0; a < shape.parts.size(); ++a)
    for (std::size_t b = a + 1; b < shape.parts.size(); ++b)
      if (b == a + 1 || unit(random) < .25) shape.contacts.push_back(contact(shape, a, b, point()));
  return make_structural_graph(std::move(shape), std::move(groups));
}

} // namespace

TEST_CASE("Exact search equals brute force on random problems, and is never above the beam")
{
  std::mt19937 random(1);
  for (int i = 0; i < 60; ++i) {
    const Energy_weights weights = i % 3 == 0 ? Energy_weights{0.6, 5} : Energy_weights{};
    const Matching_problem problem(align_shape(random_graph(random, 4)), align_shape(random_graph(random, 5)), weights);
    const Search_result exact = exact_search(problem), beam = beam_search(problem);
    CHECK(exact.optimal);
    CHECK(exact.energy == problem.energy(exact.assignment));
    CHECK(exact.energy == Approx(brute_force(problem)).margin(1e-9));
    CHECK(exact.energy <= beam.energy + 1e-9);
    CHECK(exact.summary.lower_bound == exact.energy);
  }
}

TEST_CASE("Split buckets bound from below and the search still finds the optimum")
{
  std::mt19937 random(2);
  for (int i = 0; i < 20; ++i) {
    const Matching_problem problem(align_shape(random_graph(random, 6)), align_shape(random_graph(random, 4)), {});
    Exact_options small;
    small.table_limit = 16; // pairs of groups at most
    CHECK(exact_search(problem, small).energy == Approx(exact_search(problem).energy).margin(1e-9));
  }
}

TEST_CASE("The node limit ends the search with a gap, not with a wrong proof")
{
  std::mt19937 random(3);
  const Matching_problem problem(align_shape(random_graph(random, 7)), align_shape(random_graph(random, 6)), {});
  Exact_options few;
  few.node_limit = 20;
  few.table_limit = 6;
  const Search_result result = exact_search(problem, few);
  CHECK(!result.optimal);
  CHECK(result.summary.lower_bound <= exact_search(problem).energy);
  CHECK(result.energy >= exact_search(problem).energy - 1e-9);
  CHECK(result.energy == problem.energy(result.assignment));
}

TEST_CASE("A self-match is proven to cost nothing")
{
  const Matching_problem problem(align_shape(slatted_chair()), align_shape(slatted_chair()), {});
  const Search_result result = exact_search(problem);
  CHECK(result.energy == 0);
  CHECK(result.optimal);
}

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Limits of time and memory in a match: there is always a result, which reports the limit.

#include "base/deadline.h"
#include "hand_made_graphs.h"
#include "matching/match_parts.h"
#include "random_tables.h"
#include "search/Tangents.h"
#include "search/beam_search.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/exact_search.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <catch2/catch.hpp>

#include <memory>

using namespace CGAL::Shape_correspondence;
using Catch::Matchers::Contains;

namespace {

/// A clock that advances by a second at every reading.
struct Looked_at_clock
{
  std::shared_ptr<int> looks = std::make_shared<int>(0);

  double operator()() const { return (*looks)++; }
};

internal::Deadline after(int looks) { return internal::Deadline(looks, Looked_at_clock()); }

/// Points, all in contact with each other.
Structural_graph cluster(std::size_t n)
{
  std::vector<Point> places;
  std::vector<std::array<std::size_t, 2>> contacts;
  for (std::size_t i = 0; i < n; ++i) {
    places.push_back(Point(double(i * 7 % n), double(i), double(i * 11 % n)) / double(n));
    for (std::size_t j = 0; j < i; ++j)
      contacts.push_back({j, i});
  }
  return hand_made::point_graph(places, contacts);
}

} // namespace

TEST_CASE("A search without time gives the match by parts, and says so")
{
  for (Search_method method : {Search_method::BEAM, Search_method::EXACT}) {
    Search_options options;
    options.method = method;
    options.time_limit = 1e-9;
    const Correspondence c = find_correspondence(hand_made::chair(), hand_made::chair(), options);
    CHECK(c.pairs.size() >= 6);
    CHECK_FALSE(c.complete);
    CHECK_FALSE(c.optimal);
    CHECK(c.search.method == "parts");
    REQUIRE(c.warnings.size() == 1);
    CHECK_THAT(c.warnings[0], Contains("time limit") && Contains("by their costs"));
    options.time_limit = 1000;
    CHECK(find_correspondence(hand_made::chair(), hand_made::chair(), options).warnings.empty());
  }
}

TEST_CASE("Exact search without time for its bound still has a solution")
{
  std::mt19937 random(5);
  const Pairwise_energy energy = random_tables(random, 30, 8, 8);
  Exact_options hasty;
  hasty.time_limit = 1e-9;
  Exact_search search(energy, hasty);
  const Search_result result = search.run();
  CHECK(result.out_of_time);
  CHECK_FALSE(result.optimal);
  CHECK(result.best().energy == energy(result.best().assignment));
  CHECK(result.summary.lower_bound <= result.best().energy);
  CHECK(search.min_marginals(result).size() == 30);
  hasty.time_limit = -1;
  CHECK_THROWS_AS(exact_search(energy, hasty), Invalid_input);
}

TEST_CASE("Beam search completes its best solution fast when the time is over")
{
  const Structural_graph chair = hand_made::chair(false);
  const Matching_problem problem(align_shape(chair), align_shape(chair));
  const Search_result whole = beam_search(problem);
  CHECK_FALSE(whole.out_of_time);
  for (int looks : {1, 10, 40}) {
    const Search_result result = beam_search(problem, {}, after(looks));
    CHECK(result.out_of_time);
    CHECK(result.summary.states < whole.summary.states);
    CHECK(result.best().energy == problem.energy()(result.best().assignment));
  }
}

TEST_CASE("The tables of a search check the time limit")
{
  using Shape = Deformable_shape;
  const auto chair = std::make_shared<const Shape>(align_shape(hand_made::slatted_chair()));
  std::mt19937 random(5);
  const Pairwise_energy energy = random_tables(random, 12, 4, 3);
  for (int looks : {1, 10, 20}) {
    CHECK_THROWS_AS(Matching_problem(chair, chair, Energy_options(), {}, after(looks)), internal::Out_of_time);
    CHECK_THROWS_AS(internal::elimination_order(energy, after(looks)), internal::Out_of_time);
  }
  const std::vector<std::size_t> order = internal::elimination_order(energy);
  CHECK_THROWS_AS(internal::Tangents(energy, order, 4, after(3)), internal::Out_of_time);
  internal::Tangents tangents(energy, order, 4, after(30));
  internal::Tangent_bound bound = tangents.make();
  CHECK_THROWS_AS(tangents.touch({1}, bound), internal::Out_of_time);
}

TEST_CASE("Distances of surfaces check the time limit; when it is reached, boxes are compared")
{
  const Aligned_shape chair = align_shape(hand_made::slatted_chair());
  const Part_matching_options options;
  const internal::Shape_features features(chair, options);
  for (int looks : {1, 3}) {
    const internal::Deadline late = after(looks);
    CHECK_THROWS_AS(part_costs(features, features, options, &late), internal::Out_of_time);
  }
  const Eigen::MatrixXd costs = part_costs(features, features, options, nullptr);
  CHECK(costs.diagonal().isApprox(costs.rowwise().minCoeff()));
  const internal::Deadline over(0);
  CHECK_THROWS_AS(match_parts(features, features, options, {}, &over), internal::Out_of_time);
  CHECK(match_parts(features, features, options, {}, nullptr).pairs.size() >= chair.parts.size());
}

TEST_CASE("A search that would take gigabytes gives the match by parts, and says so")
{
  const Structural_graph large = cluster(130);
  const auto shape = std::make_shared<const Deformable_shape>(align_shape(large));
  CHECK_THROWS_AS(Matching_problem(shape, shape), Too_large);
  Search_options options;
  options.method = Search_method::BEAM;
  const Correspondence c = find_correspondence(large, large, options);
  CHECK(c.search.method == "parts");
  CHECK_FALSE(c.optimal);
  REQUIRE(!c.warnings.empty());
  CHECK_THAT(c.warnings.back(), Contains("GB of memory") && Contains("by their costs"));
}

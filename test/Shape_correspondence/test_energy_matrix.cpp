// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hand_made_graphs.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/energy_matrix.h>

#include <catch2/catch.hpp>

#include <cmath>

using namespace CGAL::Shape_correspondence;

namespace {

const std::vector<Structural_graph>& shapes()
{
  static const std::vector<Structural_graph> all{hand_made::chair(), hand_made::slatted_chair(), hand_made::table(),
                                                 hand_made::pedestal_table()};
  return all;
}

Group_match group(std::vector<std::size_t> source)
{
  Group_match result;
  result.source = std::move(source);
  return result;
}

} // namespace

TEST_CASE("The distance is the energy per pair of connected parts; pairs with an unmatched part are charged")
{
  Correspondence c;
  c.energy = .6;
  c.contacts = {{{0, 1}, .2, 0}, {{1, 2}, .4, 0}, {{1, 3}, 0, 0}};
  c.groups = {group({0}), group({1}), group({2, 3})};
  CHECK(distance_energy(c, .5) == Approx(.6 / 3));
  c.unmatched_source = {3};
  CHECK(distance_energy(c, .5) == Approx((.6 + .5) / 3));
  SECTION("A part that touches nothing counts as a pair")
  {
    c.groups.push_back(group({4}));
    CHECK(distance_energy(c, .5) == Approx((.6 + .5) / 4));
    c.unmatched_source = {3, 4};
    CHECK(distance_energy(c, .5) == Approx((.6 + .5 + .5) / 4));
  }
  SECTION("Unmatched parts that the search has charged are not charged twice")
  {
    c.terms.unmatched = .3;
    CHECK(distance_energy(c, .5) == Approx(.2));
  }
  SECTION("The unmatched parts that count are those of the deformed shape")
  {
    c.direction = Direction::TARGET_TO_SOURCE;
    CHECK(distance_energy(c, .5) == Approx(.2));
    c.unmatched_target = {1};
    CHECK(distance_energy(c, .5) == Approx((.6 + 3 * .5) / 3));
  }
}

TEST_CASE("Energies and maps of all ordered pairs are those of find_correspondence()")
{
  const Energy_matrix matrix = energy_matrix(shapes());
  REQUIRE(matrix.energies.rows() == 4);
  CHECK(matrix.complete);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) {
      const double energy = matrix.energies(Eigen::Index(i), Eigen::Index(j));
      if (i == j) {
        CHECK(energy == 0);
        CHECK(matrix.map(i, j) == identity_part_map(structure(shapes()[i]).parts.size()));
        continue;
      }
      const Correspondence c = find_correspondence(shapes()[i], shapes()[j]);
      CHECK(matrix.map(i, j) == part_map(c));
      CHECK(energy == distance_energy(c, .5));
    }
  const Eigen::MatrixXd distances = symmetric_distances(matrix.energies);
  CHECK(distances(0, 1) == (matrix.energies(0, 1) + matrix.energies(1, 0)) / 2);
  CHECK(distances(0, 1) == distances(1, 0));
  CHECK(distances(0, 1) < distances(0, 2)); // a chair is nearer to a chair than to a table
}

TEST_CASE("The distance of a shape from a moved copy of itself is 0")
{
  const Energy_matrix matrix =
      energy_matrix({hand_made::chair(), hand_made::moved(hand_made::chair(), .3, 2, {1, 2, 3})});
  CHECK(matrix.energies(0, 1) == Approx(0).margin(1e-6));
  CHECK(part_pairs(matrix.map(0, 1).pairs) == part_pairs(identity_part_map(6).pairs));
}

TEST_CASE("Results in parallel have the same bits, by every method")
{
  for (Search_method method : {Search_method::PARTS, Search_method::BEAM, Search_method::EXACT}) {
    Energy_matrix_options options;
    options.search.method = method;
    const Energy_matrix one = energy_matrix(shapes(), options);
    const Energy_matrix many = energy_matrix<CGAL::Parallel_if_available_tag>(shapes(), options);
    CHECK((one.energies.array() == many.energies.array()).all());
    CHECK(one.maps == many.maps);
  }
}

TEST_CASE("Progress is reported, and cancelled work ends")
{
  Energy_matrix_options options;
  std::vector<std::size_t> told;
  options.progress = [&](std::size_t done, std::size_t total) {
    CHECK(total == 12);
    told.push_back(done);
    return true;
  };
  CHECK(energy_matrix(shapes(), options).complete);
  CHECK(told == std::vector<std::size_t>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12});
  options.progress = [](std::size_t done, std::size_t) { return done < 2; };
  const Energy_matrix cancelled = energy_matrix(shapes(), options);
  CHECK(!cancelled.complete);
  CHECK(!std::isnan(cancelled.energies(1, 0))); // computed together with its reversed pair
  CHECK(std::isnan(cancelled.energies(0, 3)));
}

TEST_CASE("Bad options are refused, and empty sets give empty results")
{
  Energy_matrix_options options;
  options.unmatched_energy = -1;
  CHECK_THROWS_AS(energy_matrix(shapes(), options), Invalid_input);
  options = {};
  options.search.solutions = 0;
  CHECK_THROWS_AS(energy_matrix<CGAL::Parallel_if_available_tag>(shapes(), options), Invalid_input);
  CHECK(energy_matrix({}).energies.size() == 0);
  CHECK(match_pairs(shapes(), {}).empty());
}

TEST_CASE("both_orders() gives the results of two matches, with pinned pairs, fewer parts and another method, too")
{
  Search_options options, pinned, coarse, beam;
  pinned.energy.pinned = {{0, 0}};
  coarse.maximum_parts = 4;
  beam.method = Search_method::BEAM;
  for (const Search_options& o : {options, pinned, coarse, beam})
    for (const Structural_graph& a : shapes())
      for (const Structural_graph& b : shapes()) {
        const std::array<Correspondence, 2> both = Correspondence_finder(a, o).both_orders(Prepared_shape(b));
        const Correspondence there = find_correspondence(a, b, o), back = find_correspondence(b, a, o);
        CHECK(part_map(both[0]) == part_map(there));
        CHECK(part_map(both[1]) == part_map(back));
        CHECK(both[0].energy == there.energy);
        CHECK(both[1].energy == back.energy);
        CHECK(both[1].unmatched_source == back.unmatched_source);
        CHECK(both[1].contacts.size() == back.contacts.size());
      }
}

TEST_CASE("Pairs of shapes can be matched in any order, alone, reversed, and twice")
{
  const std::vector<std::pair<std::size_t, std::size_t>> pairs{{2, 0}, {0, 1}, {1, 0}, {0, 1}, {3, 3}, {3, 3}};
  const std::vector<Rated_map> rated = match_pairs(shapes(), pairs);
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const Correspondence c = find_correspondence(shapes()[pairs[k].first], shapes()[pairs[k].second]);
    CHECK(rated[k].map == part_map(c));
    CHECK(rated[k].energy == distance_energy(c, .5));
  }
}

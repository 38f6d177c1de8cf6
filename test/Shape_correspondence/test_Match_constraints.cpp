// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Pinned and forbidden pairs, which all methods respect.

#include "energy/match_groups.h"
#include "hand_made_graphs.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <set>
#include <utility>

using namespace CGAL::Shape_correspondence;
using namespace hand_made;
using Pairs = Part_pairs;
using Parts = std::set<std::size_t>;

namespace {

constexpr std::size_t back = 1;

Search_options by(Search_method method)
{
  Search_options options;
  options.method = method;
  return options;
}

const auto methods = {Search_method::PARTS, Search_method::BEAM, Search_method::EXACT};

Parts partners_of_source(const Correspondence& c, std::size_t part)
{
  Parts result;
  for (const Part_correspondence& pair : c.pairs)
    if (pair.source == part) result.insert(pair.target);
  return result;
}

Parts partners_of_target(const Correspondence& c, std::size_t part)
{
  Parts result;
  for (const Part_correspondence& pair : c.pairs)
    if (pair.target == part) result.insert(pair.source);
  return result;
}

} // namespace

TEST_CASE("A pinned pair corresponds, and its parts to nothing else, by every method")
{
  for (Search_method method : methods) {
    Search_options options = by(method);
    CHECK(partners_of_source(find_correspondence(chair(), chair(), options), 2) == Parts{2});
    options.energy.pinned = {{2, 3}};
    const Correspondence c = find_correspondence(chair(), chair(), options);
    CHECK(partners_of_source(c, 2) == Parts{3});
    CHECK(partners_of_target(c, 3) == Parts{2});
    CHECK(partners_of_source(c, 0) == Parts{0});
    // Leg 3 takes the remaining front leg, and the hind legs still correspond as a pair
    if (method != Search_method::PARTS)
      CHECK(part_pairs(c.pairs) == Pairs{{0, 0}, {1, 1}, {2, 3}, {3, 2}, {4, 4}, {5, 5}});
  }
}

TEST_CASE("A part that is pinned to several corresponds to all of them, whichever shape it is of")
{
  for (Search_method method : methods) {
    Search_options options = by(method);
    options.energy.pinned = {{back, 1}, {back, 2}};
    const Correspondence split = find_correspondence(chair(), slatted_chair(), options);
    CHECK(partners_of_source(split, back) == Parts{1, 2});
    CHECK(partners_of_target(split, 1) == Parts{back});
    CHECK(partners_of_target(split, 2) == Parts{back});
    CHECK(partners_of_target(split, 3).count(back) == 0);

    options.energy.pinned = {{1, back}, {2, back}};
    const Correspondence merge = find_correspondence(slatted_chair(), chair(), options);
    CHECK(partners_of_target(merge, back) == Parts{1, 2});
    CHECK(partners_of_source(merge, 1) == Parts{back});
    CHECK(partners_of_source(merge, 3).count(back) == 0);
  }
}

TEST_CASE("Pins may join parts of different function; the remaining parts correspond among themselves")
{
  for (Search_method method : methods) {
    Search_options options = by(method);
    options.energy.pinned = {{0, back}, {back, 0}}; // swaps seat and back
    const Correspondence c = find_correspondence(chair(), chair(), options);
    CHECK(partners_of_source(c, 0) == Parts{back});
    CHECK(partners_of_source(c, back) == Parts{0});
    for (std::size_t leg : {2, 3, 4, 5})
      for (std::size_t partner : partners_of_source(c, leg))
        CHECK(partner >= 2);
  }
}

TEST_CASE("A forbidden pair does not correspond, by every method; its parts correspond to the next best ones")
{
  for (Search_method method : methods) {
    Search_options options = by(method);
    options.energy.forbidden = {{2, 2}};
    const Correspondence c = find_correspondence(chair(), chair(), options);
    CHECK(partners_of_source(c, 2).count(2) == 0);
    CHECK(partners_of_source(c, 0) == Parts{0});
    CHECK(partners_of_source(c, back) == Parts{back});
    for (std::size_t leg : {2, 3, 4, 5}) {
      REQUIRE(!partners_of_source(c, leg).empty());
      for (std::size_t partner : partners_of_source(c, leg))
        CHECK(partner >= 2);
    }
  }
}

TEST_CASE("If constraints exclude all assignments, a search throws, unless parts may stay unmatched")
{
  Search_options options = by(Search_method::EXACT);
  options.both_directions = false;
  for (std::size_t part = 0; part < 6; ++part)
    options.energy.forbidden.push_back({back, part});
  CHECK_THROWS_AS(find_correspondence(chair(), chair(), options), Invalid_input);
  options.energy.unmatched_cost = 1;
  const Correspondence c = find_correspondence(chair(), chair(), options);
  CHECK(c.unmatched_source == std::vector<std::size_t>{back});
  // The default method may leave any part unmatched
  options = by(Search_method::PARTS);
  for (std::size_t part = 0; part < 6; ++part)
    options.energy.forbidden.push_back({back, part});
  CHECK(find_correspondence(chair(), chair(), options).unmatched_source == std::vector<std::size_t>{back});
}

TEST_CASE("Constraints that cannot be satisfied are errors")
{
  const auto matched_with = [](std::vector<Part_pair> pinned, std::vector<Part_pair> forbidden, int maximum_parts = 0) {
    Search_options options;
    options.energy.pinned = std::move(pinned);
    options.energy.forbidden = std::move(forbidden);
    options.maximum_parts = maximum_parts;
    return find_correspondence(chair(), slatted_chair(), options);
  };
  CHECK_THROWS_AS(matched_with({{6, 0}}, {}), Invalid_input); // the shapes have parts 0 to 5 and 0 to 7
  CHECK_THROWS_AS(matched_with({{0, 8}}, {}), Invalid_input);
  CHECK_THROWS_AS(matched_with({}, {{6, 0}}), Invalid_input);
  CHECK_THROWS_AS(matched_with({}, {{0, 8}}), Invalid_input);
  CHECK_THROWS_AS(matched_with({{0, 0}}, {{0, 0}}), Invalid_input);
  CHECK_THROWS_AS(matched_with({{2, 4}}, {}, 1), Invalid_input); // `maximum_parts` leaves out part 2
  CHECK_NOTHROW(matched_with({}, {{2, 4}}, 1));
}

TEST_CASE("Constraints with the shapes swapped give the inverse match")
{
  Search_options options;
  options.energy.pinned = {{2, 5}};
  options.energy.forbidden = {{back, 2}};
  const Correspondence there = find_correspondence(chair(), slatted_chair(), options);
  options.energy = internal::reversed(options.energy);
  Pairs back_again;
  for (const auto& pair : part_pairs(find_correspondence(slatted_chair(), chair(), options).pairs))
    back_again.emplace_back(pair.second, pair.first);
  std::sort(back_again.begin(), back_again.end());
  CHECK(part_pairs(there.pairs) == back_again);
}

TEST_CASE("Pinned pairs that share parts are joined to pairs of sets of parts")
{
  const internal::Pinned_sets sets = internal::pinned_sets({{4, 0}, {1, 2}, {1, 3}, {5, 3}});
  REQUIRE(sets.source.size() == 2);
  CHECK(sets.source[0] == std::vector<std::size_t>{1, 5});
  CHECK(sets.target[0] == std::vector<std::size_t>{2, 3});
  CHECK(sets.source[1] == std::vector<std::size_t>{4});
  CHECK(sets.target[1] == std::vector<std::size_t>{0});
}

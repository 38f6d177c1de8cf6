// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hand_made_graphs.h"
#include "matching/match_parts.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

using namespace CGAL::Shape_correspondence;

namespace {

using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

Part_matching matching(const Structural_graph& a, const Structural_graph& b, const Part_matching_options& options = {})
{
  const Aligned_shape source = align_shape(a), target = align_shape(b);
  const Part_matching aligned = match_parts(source, target, options);
  Part_matching result = aligned;
  for (Part_correspondence& pair : result.pairs) {
    pair.source = source.original[pair.source];
    pair.target = target.original[pair.target];
  }
  std::sort(result.pairs.begin(), result.pairs.end(), is_before);
  for (Eigen::Index i = 0; i < aligned.costs.rows(); ++i)
    for (Eigen::Index j = 0; j < aligned.costs.cols(); ++j)
      result.costs(Eigen::Index(source.original[std::size_t(i)]), Eigen::Index(target.original[std::size_t(j)])) =
          aligned.costs(i, j);
  return result;
}

Pairs pairs(const Part_matching& matching) { return part_pairs(matching.pairs); }

Pairs pairs(const Structural_graph& a, const Structural_graph& b, const Part_matching_options& options = {})
{
  return pairs(matching(a, b, options));
}

Pairs identity(std::size_t parts)
{
  Pairs result;
  for (std::size_t i = 0; i < parts; ++i)
    result.emplace_back(i, i);
  return result;
}

Structural_graph reversed(const Structural_graph& graph)
{
  Shape_structure shape = structure(graph);
  const std::size_t last = shape.parts.size() - 1;
  std::reverse(shape.parts.begin(), shape.parts.end());
  for (Contact& contact : shape.contacts)
    for (std::size_t& part : contact.parts)
      part = last - part;
  std::vector<Part_group> groups;
  for (std::size_t v = num_vertices(graph); v-- > 0;) {
    groups.push_back(graph[v]);
    for (std::size_t& part : groups.back().parts)
      part = last - part;
  }
  return make_structural_graph(std::move(shape), std::move(groups));
}

// A table with a second row of legs next to the first, in its own group.
Structural_graph table_with_double_legs()
{
  Structural_graph table = hand_made::table();
  Shape_structure shape = structure(table);
  for (double z : {-.5, .5})
    for (double x : {-.4, .4}) {
      shape.parts.push_back(hand_made::curve("leg " + std::to_string(shape.parts.size()), {x, 0, z}, {x, 1, z}));
      shape.contacts.push_back(hand_made::contact(shape, 0, shape.parts.size() - 1, {x, 1, z}));
    }
  return make_structural_graph(
      std::move(shape),
      {table[0], table[1], hand_made::group({5, 6, 7, 8}, Symmetry_type::REFLECTION, Point::UnitX(), .1)});
}

} // namespace

TEST_CASE("Parts of a shape match themselves, one to one")
{
  CHECK(pairs(hand_made::chair(), hand_made::chair()) == identity(6));
  CHECK(pairs(hand_made::slatted_chair(), hand_made::slatted_chair()) == identity(8));
  CHECK(pairs(hand_made::table(), hand_made::table()) == identity(5));
}

TEST_CASE("A back matches all slats, legs match legs")
{
  CHECK(pairs(hand_made::chair(), hand_made::slatted_chair()) ==
        Pairs{{0, 0}, {1, 1}, {1, 2}, {1, 3}, {2, 4}, {3, 5}, {4, 6}, {5, 7}});
}

TEST_CASE("Four legs match one pedestal")
{
  CHECK(pairs(hand_made::table(), hand_made::pedestal_table()) == Pairs{{0, 0}, {1, 1}, {2, 1}, {3, 1}, {4, 1}});
}

TEST_CASE("Of eight legs in two groups, those at the places of the other table's legs match; the others are left over")
{
  CHECK(pairs(table_with_double_legs(), hand_made::table()) == identity(5));
}

TEST_CASE("Rows of slats at other places match all to all, and one to one if panels are switched off")
{
  const Structural_graph slats = hand_made::slatted_chair();
  Shape_structure shape = structure(slats); // its slats will be lowered and tilted
  const double x[] = {-.15, 0, .15};
  for (std::size_t slat = 1; slat <= 3; ++slat)
    shape.parts[slat] = hand_made::curve("slat", {x[slat - 1], .6, -.25}, {x[slat - 1], .9, -.4});
  const Structural_graph other = make_structural_graph(std::move(shape), {slats[0], slats[1], slats[2], slats[3]});
  Pairs expected = {{0, 0}, {1, 1}, {1, 2}, {1, 3}, {2, 1}, {2, 2}, {2, 3}, {3, 1}, {3, 2}, {3, 3}};
  for (std::size_t leg = 4; leg <= 7; ++leg)
    expected.emplace_back(leg, leg);
  CHECK(pairs(slats, other) == expected);

  Part_matching_options one_by_one;
  one_by_one.panels = false;
  CHECK(pairs(slats, other, one_by_one) == identity(8));
}

TEST_CASE("The supports of two tables correspond as sets")
{
  // A column on a plate: two parts correspond to four legs
  Shape_structure shape = structure(hand_made::pedestal_table());
  shape.parts[1] = hand_made::curve("column", {0, .05, 0}, {0, 1, 0});
  shape.parts.push_back(hand_made::sheet("plate", {-.3, 0, -.3}, {.6, 0, 0}, {0, 0, .6}));
  shape.contacts = {hand_made::contact(shape, 0, 1, {0, 1, 0}), hand_made::contact(shape, 1, 2, {0, 0, 0})};
  const Structural_graph on_plate =
      make_structural_graph(std::move(shape), {hand_made::group({0}), hand_made::group({1}), hand_made::group({2})});
  CHECK(pairs(on_plate, hand_made::table()) ==
        Pairs{{0, 0}, {1, 1}, {1, 2}, {1, 3}, {1, 4}, {2, 1}, {2, 2}, {2, 3}, {2, 4}});
}

TEST_CASE("A part on the ground beside the legs leaves them one to one")
{
  const Structural_graph table = hand_made::table();
  Shape_structure shape = structure(table);
  shape.parts.push_back(hand_made::curve("ladder", {0, 0, .5}, {0, 1, .5}));
  shape.contacts.push_back(hand_made::contact(shape, 0, 5, {0, 1, .5}));
  const Structural_graph with_ladder =
      make_structural_graph(std::move(shape), {table[0], table[1], hand_made::group({5})});
  const Pairs found = pairs(with_ladder, table);
  for (std::size_t leg = 1; leg <= 4; ++leg)
    CHECK(std::count_if(found.begin(), found.end(), [&](const auto& pair) { return pair.first == leg; }) == 1);
}

TEST_CASE("A shape with a chain hangs; rings of chains correspond to such rings or to nothing")
{
  const auto lantern = [](std::size_t links, double link) {
    Shape_structure shape;
    shape.name = "lantern";
    shape.parts = {hand_made::curve("light", {0, 0, 0}, {0, 1, 0}), hand_made::curve("arm", {-.4, .3, 0}, {.4, .3, 0})};
    double y = 1;
    for (std::size_t k = 0; k < links; ++k, y += 1.8 * link)
      shape.parts.push_back(
          hand_made::ring("link", {0, y + link, 0}, {0, link, 0}, k % 2 == 0 ? Point(link, 0, 0) : Point(0, 0, link)));
    shape.parts.push_back(hand_made::curve("mount", {-.2, y, 0}, {.2, y, 0}));
    std::vector<Part_group> groups;
    for (std::size_t k = 0; k < shape.parts.size(); ++k)
      groups.push_back(hand_made::group({k}));
    shape.contacts.push_back(hand_made::contact(shape, 0, 1, {0, .3, 0}));
    std::size_t last = 0;
    for (std::size_t k = 2; k < shape.parts.size(); last = k++)
      shape.contacts.push_back(hand_made::contact(shape, last, k, {0, 1 + 1.8 * link * double(k - 2), 0}));
    return make_structural_graph(std::move(shape), std::move(groups));
  };
  const Structural_graph hanging = lantern(4, .1), longer = lantern(6, .1), standing = lantern(0, 0);
  for (const bool swap : {false, true}) {
    const Part_matching found = swap ? matching(standing, hanging) : matching(hanging, standing);
    CHECK(found.upside_down);
    CHECK(found.pairs.size() >= 2); // pairs of lights, arms or mounts
    for (const auto& [i, j] : pairs(found)) {
      const std::size_t part = swap ? j : i;
      CHECK((part < 2 || part > 5));
    }
  }
  const Part_matching both = matching(hanging, longer);
  CHECK_FALSE(both.upside_down);
  std::size_t rings = 0;
  for (const auto& [i, j] : pairs(both)) {
    CHECK((i >= 2 && i <= 5) == (j >= 2 && j <= 7));
    rings += i >= 2 && i <= 5;
  }
  CHECK(rings >= 6); // every ring of either chain is in a pair
  CHECK(both.pairs.size() > rings);
  CHECK(matching(hanging, lantern(2, .1)).upside_down); // two rings are not a chain
}

TEST_CASE("Results are symmetric in source and target, to the bit")
{
  const Part_matching there = matching(hand_made::chair(), hand_made::slatted_chair());
  const Part_matching back = matching(hand_made::slatted_chair(), hand_made::chair());
  CHECK(there.costs == back.costs.transpose());
  REQUIRE_FALSE(there.pairs.empty());
  REQUIRE(there.pairs.size() == back.pairs.size());
  for (const Part_correspondence& pair : there.pairs) {
    const auto same = std::find_if(back.pairs.begin(), back.pairs.end(), [&](const Part_correspondence& other) {
      return other.source == pair.target && other.target == pair.source;
    });
    REQUIRE(same != back.pairs.end());
    CHECK(same->confidence == pair.confidence);
  }
}

TEST_CASE("Matches do not depend on position, scale, turning and part order")
{
  const Structural_graph chair = hand_made::chair(), slats = hand_made::slatted_chair();
  const Pairs expected = pairs(chair, slats);
  CHECK(pairs(chair, hand_made::moved(slats, -0.6, 0.01, {70, 3, -4})) == expected);

  Pairs in_order = pairs(chair, reversed(slats));
  for (auto& pair : in_order)
    pair.second = 7 - pair.second;
  std::sort(in_order.begin(), in_order.end());
  CHECK(in_order == expected);
  CHECK(matching(chair, reversed(slats)).costs == matching(chair, slats).costs.rowwise().reverse());
}

TEST_CASE("A smaller limit of excess costs gives fewer pairs, all of which a larger one gives, too")
{
  Part_matching_options strict, generous;
  strict.excess = strict.confident_excess = 0;
  generous.excess = 5;
  const Pairs few = pairs(table_with_double_legs(), hand_made::table(), strict);
  const Pairs many = pairs(table_with_double_legs(), hand_made::table(), generous);
  CHECK(few.size() < many.size());
  CHECK(std::includes(many.begin(), many.end(), few.begin(), few.end()));
}

TEST_CASE("Confidence: a probability, high where there is no doubt and lower where there is")
{
  const auto confidence = [](const Part_matching& matching, std::size_t source, std::size_t target) {
    for (const Part_correspondence& pair : matching.pairs)
      if (pair.source == source && pair.target == target) return pair.confidence;
    return 0.;
  };
  const Part_matching same = matching(hand_made::chair(), hand_made::chair());
  REQUIRE(same.pairs.size() == structure(hand_made::chair()).parts.size());
  for (const Part_correspondence& pair : same.pairs) {
    CHECK(pair.confidence > 0.8);
    CHECK(pair.confidence < 1);
  }
  Part_matching_options strict; // either of two adjacent legs is a candidate, but there is only one top
  strict.excess = strict.confident_excess = 0;
  const Part_matching doubtful = matching(table_with_double_legs(), hand_made::table(), strict);
  CHECK(confidence(doubtful, 1, 1) > 0);
  CHECK(confidence(doubtful, 1, 1) < confidence(doubtful, 0, 0));
}

TEST_CASE("Weights and bounds that are negative or not finite are refused")
{
  Part_matching_options options;
  options.excess = -1;
  CHECK_THROWS_AS(matching(hand_made::chair(), hand_made::chair(), options), Invalid_input);
  options = {};
  options.weights.chamfer = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(matching(hand_made::chair(), hand_made::chair(), options), Invalid_input);
  for (double Part_matching_options::*positive :
       {&Part_matching_options::tolerance, &Part_matching_options::anchor, &Part_matching_options::warp_width}) {
    options = {};
    options.*positive = 0;
    CHECK_THROWS_AS(matching(hand_made::chair(), hand_made::chair(), options), Invalid_input);
  }
  options = {};
  options.clearly_better = 1;
  CHECK_THROWS_AS(matching(hand_made::chair(), hand_made::chair(), options), Invalid_input);
  options = {};
  options.repetition = 1;
  CHECK_THROWS_AS(matching(hand_made::chair(), hand_made::chair(), options), Invalid_input);
}

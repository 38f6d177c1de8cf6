// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hand_made_graphs.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/build_structural_graph.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <random>
#include <set>

// `Search_method::PARTS`, the default of find_correspondence().

using namespace CGAL::Shape_correspondence;
using namespace hand_made;
using Pairs = Part_pairs;

TEST_CASE("By default parts are matched by their costs, with a confidence each, and rated by the energy")
{
  const Correspondence self = find_correspondence(chair(), chair());
  CHECK(part_pairs(self.pairs) == Pairs{{0, 0}, {1, 1}, {2, 2}, {3, 3}, {4, 4}, {5, 5}});
  CHECK(self.energy == 0);
  CHECK(self.complete);
  CHECK(self.search.method == "parts");

  const Correspondence split = find_correspondence(chair(), slatted_chair());
  CHECK(part_pairs(split.pairs) == Pairs{{0, 0}, {1, 1}, {1, 2}, {1, 3}, {2, 4}, {3, 5}, {4, 6}, {5, 7}});
  for (const Part_correspondence& pair : split.pairs)
    CHECK((pair.confidence > 0 && pair.confidence < 1));
  CHECK(split.groups[1].operation == Operation::SPLIT);
  CHECK(split.groups[1].solidity_ratio == Approx(0.4));
  CHECK(split.energy == Approx(deformation_energy(split.terms, {})));
  // The exact search finds the same pairs at less energy, since it rates each slat with a third of the back only
  Search_options exact;
  exact.method = Search_method::EXACT;
  exact.both_directions = false;
  const Correspondence least = find_correspondence(chair(), slatted_chair(), exact);
  CHECK(part_pairs(least.pairs) == part_pairs(split.pairs));
  CHECK(split.energy > least.energy);
}

TEST_CASE("The default gives the same pairs with the shapes swapped")
{
  Pairs turned;
  for (const Part_correspondence& pair : find_correspondence(slatted_chair(), chair()).pairs)
    turned.emplace_back(pair.target, pair.source);
  std::sort(turned.begin(), turned.end());
  CHECK(turned == part_pairs(find_correspondence(chair(), slatted_chair()).pairs));
}

TEST_CASE("Pairs that are not sure enough can be left out; other parts stay matched")
{
  Search_options options;
  const Correspondence all = find_correspondence(chair(), slatted_chair(), options);
  for (const Part_correspondence& pair : all.pairs)
    options.min_confidence = std::max(options.min_confidence, pair.confidence);
  const Correspondence sure = find_correspondence(chair(), slatted_chair(), options);
  CHECK(!sure.pairs.empty());
  CHECK(sure.pairs.size() <= all.pairs.size());
  for (const Part_correspondence& pair : sure.pairs)
    CHECK(pair.confidence == options.min_confidence);
  options.min_confidence = 1;
  const Correspondence none = find_correspondence(chair(), slatted_chair(), options);
  CHECK(none.pairs.empty());
  CHECK(none.unmatched_source.size() == 6);
  CHECK(std::isfinite(none.energy));
  options.min_confidence = 2;
  CHECK_THROWS_AS(find_correspondence(chair(), chair(), options), Invalid_input);
}

TEST_CASE("Another alignment than the given one must be clearly better")
{
  // A seat on four legs: hind legs closer together by the share `narrowing`, all feet farther out by the share `lean`
  const auto stool = [](double narrowing, double lean) {
    Shape_structure shape;
    shape.frame.mirror_x = shape.frame.mirror_z = true;
    shape.parts = {sheet("seat", {-.25, 1, -.25}, {.5, 0, 0}, {0, 0, .5})};
    for (const double z : {-.25, .25})
      for (const double x : {-.25, .25}) {
        const double top = x * (z < 0 ? 1 - narrowing : 1);
        shape.parts.push_back(curve("leg", {top + lean * x, 0, z + lean * z}, {top, 1, z}));
        shape.contacts.push_back(contact(shape, 0, shape.parts.size() - 1, {top, 1, z}));
      }
    return make_structural_graph(std::move(shape), {group({0}), group({1, 2}, Symmetry_type::REFLECTION),
                                                    group({3, 4}, Symmetry_type::REFLECTION)});
  };
  const Structural_graph leaning = stool(0.02, 1);
  Search_options all;
  all.alignments = 0;
  // An alignment by two quarter turns is only slightly better
  CHECK(find_correspondence(stool(-0.02, 0), leaning, all).target_quarter_turns == 0);
  CHECK(find_correspondence(stool(-0.9, 0), stool(0.9, 1), all).target_quarter_turns == 2);
}

TEST_CASE("The default method matches chosen parts only, and tries all alignments where asked to")
{
  Search_options options;
  options.source_parts = {0, 2, 3};
  options.target_parts = {0, 4, 5};
  const Correspondence c = find_correspondence(chair(), chair(), options);
  for (const auto& pair : c.pairs) {
    CHECK((pair.source == 0 || pair.source == 2 || pair.source == 3));
    CHECK((pair.target == 0 || pair.target == 4 || pair.target == 5));
  }
  Structural_graph turned = moved(chair(), EIGEN_PI, 1, {0, 0, 0});
  structure(turned).frame.axes.setIdentity();
  options = {};
  options.alignments = 0;
  CHECK(find_correspondence(chair(), turned, options).target_quarter_turns == 2);
}

namespace {

/// Curves and sheets at random places, in a frame rotated by quarter turns.
Structural_graph random_parts(std::mt19937& random, int quarter_turns)
{
  std::uniform_real_distribution<double> coordinate(0, 1);
  const auto place = [&] {
    const double x = coordinate(random), y = coordinate(random);
    return Point(x, y, coordinate(random));
  };
  Shape_structure shape;
  const std::size_t n = 4 + random() % 5;
  for (std::size_t i = 0; i < n; ++i) {
    const std::string name = "part " + std::to_string(i);
    const Point a = place(), b = place(), c = place();
    shape.parts.push_back(i % 2 == 0 ? curve(name, a, b) : sheet(name, a, b - a, c - a));
  }
  const Eigen::AngleAxisd turn(quarter_turns * EIGEN_PI / 2, Point::UnitY());
  shape.frame.axes = turn.toRotationMatrix();
  Structure_options options;
  options.symmetry.enabled = false;
  return complete_structural_graph(std::move(shape), {}, options);
}

} // namespace

TEST_CASE("The default finds the same pairs from either shape, also where their frames are a quarter turn apart")
{
  std::mt19937 random(1);
  for (int trial = 0; trial < 40; ++trial) {
    CAPTURE(trial);
    const Structural_graph source = random_parts(random, 0), target = random_parts(random, trial % 4);
    std::set<std::pair<std::size_t, std::size_t>> there, back;
    for (const Part_correspondence& pair : find_correspondence(source, target).pairs)
      there.emplace(pair.source, pair.target);
    for (const Part_correspondence& pair : find_correspondence(target, source).pairs)
      back.emplace(pair.target, pair.source);
    CHECK(there == back);
  }
}

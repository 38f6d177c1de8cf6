// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

#include "hand_made_graphs.h"

#include <catch2/catch.hpp>

using namespace CGAL::Shape_correspondence;
using namespace hand_made;
using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

TEST_CASE("A shape corresponds to itself, at no cost")
{
  const Correspondence c = find_correspondence(chair(), chair());
  CHECK(c.energy == 0);
  CHECK(c.complete);
  CHECK(c.pairs == Pairs{{0, 0}, {1, 1}, {2, 2}, {3, 3}, {4, 4}, {5, 5}});
  CHECK(c.unmatched_source.empty());
  CHECK(c.unmatched_target.empty());
  CHECK(c.direction == Direction::SOURCE_TO_TARGET);
}

TEST_CASE("A back splits into slats, and slats merge into a back")
{
  const Pairs expected = {{0, 0}, {1, 1}, {1, 2}, {1, 3}, {2, 4}, {3, 5}, {4, 6}, {5, 7}};
  Search_options forward;
  forward.both_directions = false;
  const Correspondence split = find_correspondence(chair(), slatted_chair(), forward);
  CHECK(split.pairs == expected);
  CHECK(split.groups[1].operation == Operation::SPLIT);
  CHECK(split.groups[1].source == std::vector<std::size_t>{1});
  CHECK(split.groups[1].target == std::vector<std::size_t>{1, 2, 3});
  CHECK(split.terms.split > 0);

  const Correspondence merge = find_correspondence(slatted_chair(), chair(), forward);
  Pairs turned;
  for (const auto& pair : expected)
    turned.emplace_back(pair.second, pair.first);
  std::sort(turned.begin(), turned.end());
  CHECK(merge.pairs == turned);
  CHECK(merge.groups[1].operation == Operation::MERGE);

  // Both directions: pairs stay (source, target) whichever direction won
  CHECK(find_correspondence(chair(), slatted_chair()).pairs == expected);
  CHECK(find_correspondence(slatted_chair(), chair()).pairs == turned);
}

TEST_CASE("The parts of the energy add up")
{
  const Correspondence c = find_correspondence(chair(), slatted_chair());
  CHECK(c.energy == Approx(c.terms.distortion + 0.6 * c.terms.connectedness + 0.4 * c.terms.split));
  Energy_terms sum;
  for (const Contact_energy& contact : c.contacts) {
    sum.distortion += contact.distortion;
    sum.connectedness += contact.connectedness;
  }
  CHECK(sum.distortion == Approx(c.terms.distortion));
  CHECK(sum.connectedness == Approx(c.terms.connectedness));
  double groups = 0;
  std::vector<double> ratios;
  for (const Group_match& match : c.groups) {
    groups += match.energy;
    CHECK(match.energy == Approx(match.distortion + 0.6 * match.connectedness));
    ratios.push_back(match.solidity_ratio);
  }
  CHECK(split_energy(ratios) == Approx(c.terms.split));
  CHECK(groups == Approx(c.energy - 0.4 * c.terms.split));
  CHECK(c.search.lower_bound <= c.energy);
}

TEST_CASE("Moving, scaling and turning a shape changes no pair")
{
  const Pairs expected = find_correspondence(chair(), slatted_chair()).pairs;
  for (const double angle : {0.5236, -0.7, 0.2})
    for (const double scale : {0.01, 40.0}) {
      const Structural_graph turned = moved(slatted_chair(), angle, scale, {3, 100, -7});
      CHECK(find_correspondence(chair(), turned).pairs == expected);
    }
}

TEST_CASE("A chair turned back to front is recognised when all alignments are tried")
{
  // The frame of a chair that was given back to front looks the other way
  Structural_graph turned = moved(chair(), EIGEN_PI, 1, {0, 0, 0});
  structure(turned).frame.axes.setIdentity();
  Search_options all;
  all.alignments = 0;
  const Correspondence c = find_correspondence(chair(), turned, all);
  CHECK(c.target_quarter_turns == 2);
  CHECK(c.energy == Approx(0).margin(1e-9));
  CHECK(c.pairs == Pairs{{0, 0}, {1, 1}, {2, 2}, {3, 3}, {4, 4}, {5, 5}});
}

TEST_CASE("Coarse correspondence leaves the lesser parts out and says so")
{
  Search_options coarse;
  coarse.maximum_parts = 2;
  const Correspondence c = find_correspondence(chair(), chair(), coarse);
  CHECK(c.pairs == Pairs{{0, 0}, {1, 1}});
  CHECK(c.unmatched_source == std::vector<std::size_t>{2, 3, 4, 5});
}

TEST_CASE("Options out of range are refused")
{
  Search_options options;
  options.weights.split = -1;
  CHECK_THROWS_AS(find_correspondence(chair(), chair(), options), Invalid_input);
  options = {};
  options.alignments = -1;
  CHECK_THROWS_AS(find_correspondence(chair(), chair(), options), Invalid_input);
  options = {};
  options.beam.beam_width = 0;
  CHECK_THROWS_AS(find_correspondence(chair(), chair(), options), Invalid_input);
}

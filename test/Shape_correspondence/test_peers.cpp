// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hand_made_graphs.h"
#include "peers/peers.h"

#include <catch2/catch.hpp>

#include <algorithm>

// The methods with which the benchmark compares: they run, without checks of quality.

using namespace CGAL::Shape_correspondence;

namespace {

bool contains(const Part_pairs& pairs, std::size_t source, std::size_t target)
{
  return std::find(pairs.begin(), pairs.end(), std::pair(source, target)) != pairs.end();
}

} // namespace

TEST_CASE("Every method matches the parts of a shape with themselves")
{
  const std::vector<Structural_graph> shapes{hand_made::chair(), hand_made::slatted_chair(), hand_made::chair()};
  for (const peers::Named_peer& peer : peers::all_peers()) {
    const std::vector<Part_pairs> matches = peer.match(shapes, {{0, 2}, {0, 1}, {1, 0}});
    REQUIRE(matches.size() == 3);
    INFO(peer.name);
    for (std::size_t i = 0; i < structure(shapes[0]).parts.size(); ++i)
      CHECK(contains(matches[0], i, i));
    for (const auto& [i, j] : matches[1]) {
      CHECK(i < structure(shapes[0]).parts.size());
      CHECK(j < structure(shapes[1]).parts.size());
    }
    CHECK(contains(matches[1], 0, 0)); // the seats
    CHECK(contains(matches[2], 0, 0));
  }
}

TEST_CASE("Assignment is one to one, and nearest parts leave no source part without a pair")
{
  const std::vector<Structural_graph> shapes{hand_made::chair(), hand_made::slatted_chair()};
  const auto matches = [&](const peers::Peer& peer) { return peer(shapes, {{0, 1}}).front(); };
  const Part_pairs assigned = matches(peers::pairwise(peers::match_by_assignment));
  CHECK(assigned.size() == structure(shapes[0]).parts.size());
  std::vector<std::size_t> targets;
  for (const auto& pair : assigned)
    targets.push_back(pair.second);
  std::sort(targets.begin(), targets.end());
  CHECK(std::unique(targets.begin(), targets.end()) == targets.end());
  CHECK(matches(peers::pairwise(peers::match_nearest_parts)).size() == structure(shapes[0]).parts.size());
}

TEST_CASE("Distances of point sets, and the strong entries of a matrix, worked out by hand")
{
  Points a(3, 2), b(3, 1);
  a << 0, 1, 0, 0, 0, 0;
  b << 0, .5, 0;
  CHECK(peers::hausdorff(a, b) == Approx(std::sqrt(1.25)));
  CHECK(peers::chamfer(a, b) == Approx(((.5 + std::sqrt(1.25)) / 2 + .5) / 2));
  Eigen::MatrixXd weights(2, 2);
  weights << 4, 1, 3, 2;
  CHECK(peers::strong_entries(weights, .5) == Part_pairs{{0, 0}, {1, 0}, {1, 1}});
  CHECK(peers::strong_entries(weights, 1) == Part_pairs{{0, 0}});
}

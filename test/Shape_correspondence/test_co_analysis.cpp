// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "collection/part_matrix.h"
#include "hand_made_graphs.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/co_analysis.h>
#include <CGAL/Shape_correspondence/energy_matrix.h>

#include <catch2/catch.hpp>

using namespace CGAL::Shape_correspondence;

namespace {

Part_map certain(const Part_pairs& pairs)
{
  Part_map map;
  for (const auto& [source, target] : pairs)
    map.pairs.push_back({source, target, 1});
  return map;
}

} // namespace

TEST_CASE("Pairs that third shapes contradict are rejected")
{
  // Parts 0 and 1 of four shapes correspond, except that one map swaps them
  std::vector<Shape_pair_map> maps;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < i; ++j)
      maps.push_back({i, j, i == 3 && j == 1 ? certain({{0, 1}, {1, 0}}) : certain({{0, 0}, {1, 1}})});
  const Part_matrix kept = part_matrix({2, 2, 2, 2}, maps, 0), cleaned = part_matrix({2, 2, 2, 2}, maps, .4);
  CHECK(kept.confidences.nonZeros() == 24);
  CHECK(cleaned.rejected == 2);
  CHECK(cleaned.confidences.nonZeros() == 20);
  CHECK(cleaned.confidences.coeff(6, 3) == 0); // both third shapes contradict the pair
  CHECK(cleaned.confidences.coeff(6, 2) == 0); // no map has the pair
  CHECK(cleaned.confidences.coeff(6, 0) == 1); // one of two third shapes confirms the pair
  const Co_analysis result = co_analysis({2, 2, 2, 2}, maps);
  CHECK(result.labels == std::vector<std::vector<int>>(4, {0, 1}));
  CHECK(result.part_pairs == 10);
  CHECK(result.rejected_pairs == 2);
}

TEST_CASE("Two shapes have no third one that could confirm anything")
{
  CHECK(part_matrix({1, 1}, {{0, 1, certain({{0, 0}})}}, 1).rejected == 0);
}

TEST_CASE("The largest cluster is the first label; parts similar to no others have none")
{
  // Part 1 of shape 0 corresponds to parts 0 and 1 of shape 1, part 2 of shape 1 to the part of shape 2
  const Co_analysis result = co_analysis({2, 3, 1}, {{0, 1, certain({{1, 0}, {1, 1}})}, {1, 2, certain({{2, 0}})}});
  CHECK(result.labels == std::vector<std::vector<int>>{{Co_analysis::none, 0}, {0, 0, 1}, {1}});
  CHECK(result.number_of_labels == 2);
}

TEST_CASE("Chairs agree on what is a seat, a back and a leg")
{
  const std::vector<Structural_graph> shapes{hand_made::chair(), hand_made::slatted_chair(), hand_made::chair(false)};
  const Energy_matrix matrix = energy_matrix(shapes);
  std::vector<Shape_pair_map> maps;
  std::vector<std::size_t> counts;
  for (std::size_t i = 0; i < 3; ++i) {
    counts.push_back(structure(shapes[i]).parts.size());
    for (std::size_t j = 0; j < 3; ++j)
      if (i != j) maps.push_back({i, j, matrix.map(i, j)});
  }
  const Co_analysis result = co_analysis(counts, maps);
  CHECK(result.labels[0] == result.labels[2]);
  CHECK(result.labels[1][0] == result.labels[0][0]);
  for (std::size_t slat : {1, 2, 3})
    CHECK(result.labels[1][slat] == result.labels[0][1]);
  for (std::size_t leg : {2, 3, 4, 5})
    CHECK(result.labels[1][leg + 2] == result.labels[0][leg]);
  CHECK(result.labels[0][0] != result.labels[0][1]);
  CHECK(result.labels[0][0] != result.labels[0][2]);
  CHECK(result.labels[0][1] != result.labels[0][4]);
}

TEST_CASE("Pairs of parts in one cluster agree with the whole set; pairs of parts in no cluster do not")
{
  Co_analysis analysis;
  analysis.labels = {{0, 1, Co_analysis::none}, {0, 0, 1, Co_analysis::none}};
  const std::vector<Shape_pair_map> maps{
      {0, 1, certain({{0, 0}, {0, 1}, {0, 2}, {1, 0}, {1, 2}, {2, 3}})}, {1, 0, certain({{0, 1}, {2, 1}})}, {0, 1, {}}};
  const std::vector<Shape_pair_map> agreeing = agreeing_maps(maps, analysis);
  REQUIRE(agreeing.size() == 3);
  CHECK(agreeing[0].map == certain({{0, 0}, {0, 1}, {1, 2}}));
  CHECK(agreeing[1].map == certain({{2, 1}}));
  CHECK(agreeing[2].map.pairs.empty());
}

TEST_CASE("Maps of shapes that do not exist are refused")
{
  CHECK_THROWS_AS(co_analysis({1, 1}, {{0, 2, certain({{0, 0}})}}), Invalid_input);
  CHECK_THROWS_AS(co_analysis({1, 1}, {{0, 1, certain({{0, 1}})}}), Invalid_input);
  Co_analysis_options options;
  options.least_cycle_support = 2;
  CHECK_THROWS_AS(co_analysis({1, 1}, {}, options), Invalid_input);
}

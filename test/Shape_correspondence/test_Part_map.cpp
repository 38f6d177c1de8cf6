// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Shape_correspondence/Part_map.h>

#include <catch2/catch.hpp>

using namespace CGAL::Shape_correspondence;

TEST_CASE("A part map keeps the pairs of a correspondence, and is certain where the method has no confidences")
{
  Correspondence correspondence;
  correspondence.pairs = {{0, 1}, {2, 0}};
  CHECK(part_map(correspondence) == Part_map{{{0, 1}, {2, 0}}, {1, 1}});
  correspondence.confidences = {.5, .25};
  CHECK(part_map(correspondence) == Part_map{{{0, 1}, {2, 0}}, {.5, .25}});
}

TEST_CASE("The inverse map is sorted by the other side, with its confidences")
{
  const Part_map map{{{0, 2}, {1, 0}, {1, 1}}, {.1, .2, .3}};
  CHECK(inverse(map) == Part_map{{{0, 1}, {1, 1}, {2, 0}}, {.2, .3, .1}});
  CHECK(inverse(inverse(map)) == map);
}

TEST_CASE("Maps compose by the parts in between, each pair once, by its most probable way")
{
  // 0 has two ways to 5, of .5 · .4 and .9 · .8; 1 splits into 6 and 7; 2 ends half-way
  const Part_map first{{{0, 0}, {0, 1}, {1, 2}, {2, 3}}, {.5, .9, 1, 1}};
  const Part_map second{{{0, 5}, {1, 5}, {2, 6}, {2, 7}, {4, 8}}, {.4, .8, .25, .75, 1}};
  const Part_map result = composed(first, second);
  CHECK(result.pairs == std::vector<std::pair<std::size_t, std::size_t>>{{0, 5}, {1, 6}, {1, 7}});
  REQUIRE(result.confidences.size() == 3);
  CHECK(result.confidences[0] == Approx(.72));
  CHECK(result.confidences[1] == .25);
  CHECK(result.confidences[2] == .75);
}

TEST_CASE("The identity changes no map, and nothing comes of nothing")
{
  const Part_map map{{{0, 2}, {1, 0}}, {.1, .2}};
  CHECK(composed(identity_part_map(2), map) == map);
  CHECK(composed(map, identity_part_map(3)) == map);
  CHECK(composed(map, Part_map()) == Part_map());
  CHECK(inverse(Part_map()) == Part_map());
}

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Shape_correspondence/Correspondence.h>
#include <CGAL/Shape_correspondence/Part_map.h>

#include <catch2/catch.hpp>

using namespace CGAL::Shape_correspondence;

TEST_CASE("A part map keeps the pairs of a correspondence, and is certain where the method has no confidences")
{
  Correspondence correspondence;
  correspondence.pairs = {{0, 1}, {2, 0}};
  CHECK(part_map(correspondence) == Part_map{{{0, 1, 1}, {2, 0, 1}}});
  correspondence.pairs = {{0, 1, .5, {0, 2}}, {2, 0, .25}};
  CHECK(part_map(correspondence) == Part_map{{{0, 1, .5}, {2, 0, .25}}});
}

TEST_CASE("The inverse map is sorted by the other side, with its confidences")
{
  const Part_map map{{{0, 2, .1}, {1, 0, .2}, {1, 1, .3}}};
  CHECK(inverse(map) == Part_map{{{0, 1, .2}, {1, 1, .3}, {2, 0, .1}}});
  CHECK(inverse(inverse(map)) == map);
}

TEST_CASE("Maps compose over intermediate parts; each pair has the probability of its most probable path")
{
  // Part 0 has the image 5 in two ways, .5 · .4 and .9 · .8; part 1 splits into 6 and 7; 2 has no image by both maps
  const Part_map first{{{0, 0, .5}, {0, 1, .9}, {1, 2, 1}, {2, 3, 1}}};
  const Part_map second{{{0, 5, .4}, {1, 5, .8}, {2, 6, .25}, {2, 7, .75}, {4, 8, 1}}};
  const Part_map result = composed(first, second);
  REQUIRE(part_pairs(result.pairs) == Part_pairs{{0, 5}, {1, 6}, {1, 7}});
  CHECK(result.pairs[0].confidence == Approx(.72));
  CHECK(result.pairs[1].confidence == .25);
  CHECK(result.pairs[2].confidence == .75);
}

TEST_CASE("Composing with the identity changes no map; empty maps give empty maps")
{
  const Part_map map{{{0, 2, .1}, {1, 0, .2}}};
  CHECK(composed(identity_part_map(2), map) == map);
  CHECK(composed(map, identity_part_map(3)) == map);
  CHECK(composed(map, Part_map()) == Part_map());
  CHECK(inverse(Part_map()) == Part_map());
}

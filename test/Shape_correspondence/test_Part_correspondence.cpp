// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Shape_correspondence/Part_correspondence.h>

#include <catch2/catch.hpp>

using namespace CGAL::Shape_correspondence;

TEST_CASE("A pair without a confidence equals the same pair without a confidence")
{
  const Part_correspondence pair{1, 2}, sure{1, 2, 1};
  CHECK_FALSE(pair.has_confidence());
  CHECK(sure.has_confidence());
  CHECK(pair == Part_correspondence{1, 2});
  CHECK_FALSE(pair == sure);
  CHECK_FALSE(sure == pair);
  CHECK_FALSE(sure == Part_correspondence{1, 2, .5});
  CHECK(pair.source_segment.is_whole_part());
}

TEST_CASE("The inverse of a pair has the segments of the other sides")
{
  const Part_correspondence pair{1, 2, .5, {2, 3}, {}};
  CHECK(inverse(pair) == Part_correspondence{2, 1, .5, {}, {2, 3}});
  CHECK(inverse(inverse(pair)) == pair);
  CHECK_FALSE(inverse(pair).target_segment.is_whole_part());
}

TEST_CASE("Pairs are in the order of their source parts, then of their target parts")
{
  CHECK(is_before({1, 2}, {2, 0}));
  CHECK(is_before({1, 2}, {1, 3}));
  CHECK_FALSE(is_before({1, 2}, {1, 2, .5}));
  CHECK_FALSE(is_before({2, 0}, {1, 2}));
  CHECK(part_pairs({{1, 2, .5}, {1, 3}}) == Part_pairs{{1, 2}, {1, 3}});
}

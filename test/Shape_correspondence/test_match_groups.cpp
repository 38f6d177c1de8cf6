// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "aligned_graphs.h"
#include "energy/match_groups.h"

#include <catch2/catch.hpp>

#include <set>

using namespace CGAL::Shape_correspondence;
using namespace hand_made;

TEST_CASE("Groups: members correspond one to one by their places, and those left over to the nearest")
{
  const Aligned_shape plain = align_shape(chair()), slats = align_shape(slatted_chair());
  const auto group_with = [](const Aligned_shape& shape, std::size_t original) {
    return shape.group_of[index_of(shape, original)];
  };

  const Group_label legs = match_groups(plain, group_with(plain, 2), slats, group_with(slats, 4));
  CHECK(legs.operation == Operation::MATCH);
  for (std::size_t i = 0; i < 2; ++i) {
    REQUIRE(legs.images[i].size() == 1);
    const std::size_t from = plain.original[plain.group(group_with(plain, 2)).parts[i]];
    CHECK(slats.original[legs.images[i][0].target.part] == from + 2); // left corresponds to left, right to right
  }

  const Group_label split = match_groups(plain, group_with(plain, 1), slats, group_with(slats, 1));
  CHECK(split.operation == Operation::SPLIT);
  CHECK(split.images[0].size() == 3);
  CHECK(split.solidity_ratio == Approx(0.4));
  CHECK(legs.solidity_ratio == 1); // matched one to one

  const Group_label merge = match_groups(slats, group_with(slats, 1), plain, group_with(plain, 1));
  CHECK(merge.operation == Operation::MERGE);
  CHECK(merge.images.size() == 3);

  const Group_label duplicate = match_groups(plain, group_with(plain, 2), slats, group_with(slats, 1));
  CHECK(duplicate.operation == Operation::DUPLICATE);
  std::set<std::size_t> taken;
  for (const auto& images : duplicate.images)
    for (const Piece_image& image : images)
      taken.insert(image.target.part);
  CHECK(taken.size() == 3); // every target part is an image
}

TEST_CASE("Groups: members are matched by their places in unit boxes, one left over goes to the nearest")
{
  // Members at 0 and 1 of one unit box, and at 0, 0.8 and 1 of the other
  const Aligned_shape two = align_shape(point_graph({{0, -1, 0}, {10, 0, 0}, {12, 0, 0}}, {{0, 1}},
                                                    {group({0}), group({1, 2}, Symmetry_type::TRANSLATION)}));
  const Aligned_shape three = align_shape(point_graph({{0, -1, 0}, {0, 0, 0}, {.8, 0, 0}, {1, 0, 0}}, {{0, 1}},
                                                      {group({0}), group({1, 2, 3}, Symmetry_type::TRANSLATION)}));
  const Group_label duplicate = match_groups(two, 1, three, 1), merge = match_groups(three, 1, two, 1);
  REQUIRE(duplicate.images[0].size() == 1);
  REQUIRE(duplicate.images[1].size() == 2);
  CHECK(duplicate.images[0][0].target.part == 1);
  CHECK(duplicate.images[1][0].target.part == 2);
  CHECK(duplicate.images[1][1].target.part == 3);
  for (std::size_t i = 0; i < 3; ++i)
    CHECK(merge.images[i][0].target.part == (i == 0 ? 1 : 2));
}

TEST_CASE("The solidity ratio is 1 except for groups of different sizes without rotational symmetry")
{
  const auto group = [](std::size_t size, double solidity, Symmetry_type type = Symmetry_type::REFLECTION) {
    Part_group result;
    result.parts.resize(size);
    result.volume = solidity;
    result.hull_volume = 1;
    result.symmetry.type = type;
    return result;
  };
  CHECK(solidity_ratio(group(1, .8), group(3, .2)) == Approx(.25));
  CHECK(solidity_ratio(group(4, .2), group(2, .1)) == Approx(.5));
  CHECK(solidity_ratio(group(1, .8), group(1, .2)) == 1);
  CHECK(solidity_ratio(group(2, .8), group(2, .2)) == 1);
  CHECK(solidity_ratio(group(1, .8), group(3, .2, Symmetry_type::ROTATION)) == 1);
}

TEST_CASE("Unit boxes: a group fills its own, and is in the middle of an axis along which it is flat")
{
  const internal::Unit_box box(Eigen::AlignedBox3d(Point(1, 2, 5), Point(3, 3, 5.01)));
  CHECK(box({1, 2, 5}).isApprox(Point(0, 0, .5)));
  CHECK(box({3, 2.5, 5.01}).isApprox(Point(1, .5, .5)));
}

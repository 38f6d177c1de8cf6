// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "aligned_graphs.h"
#include "base/divide_box.h"
#include "energy/cut_parts.h"

#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <vector>

using namespace CGAL::Shape_correspondence;
using namespace hand_made;

namespace {

// A rail with a panel below it (parts 0 and 1), or with `bars` vertical bars in the place of the panel.
Structural_graph gate(int bars, double solidity = 1)
{
  Shape_structure shape;
  shape.frame.mirror_x = true;
  shape.parts = {curve("rail", {-.5, 1, 0}, {.5, 1, 0})};
  std::vector<std::size_t> members;
  for (int i = 0; i < std::max(1, bars); ++i) {
    members.push_back(shape.parts.size());
    const double x = bars > 0 ? -.5 + (i + .5) / bars : 0;
    shape.parts.push_back(bars > 0 ? curve("bar " + std::to_string(i), {x, 0, 0}, {x, 1, 0})
                                   : sheet("panel", {-.5, 0, 0}, {1, 0, 0}, {0, 1, 0}));
    shape.contacts.push_back(contact(shape, 0, members.back(), {x, 1, 0}));
  }
  const auto type = bars > 1 ? Symmetry_type::TRANSLATION : Symmetry_type::SELF;
  return make_structural_graph(std::move(shape), {group({0}), group(members, type, {.5, 0, 0}, solidity)});
}

} // namespace

TEST_CASE("A box is divided along the axis of most spread, in proportion to extents")
{
  using internal::divide_box;
  using Box = Eigen::AlignedBox3d;
  const Box unit(Point::Zero(), Point::Ones());
  CHECK(divide_box(unit, {{{7, 7, 7}, {1, 1, 1}}})[0].isApprox(unit));

  // The share in the middle is twice as wide as the other two; shares come in any order
  const auto three = divide_box(unit, {{{5, 0, 0}, {1, 1, 1}}, {{-5, 0, 0}, {1, 1, 1}}, {{0, 0, 0}, {2, 1, 1}}});
  CHECK(three[0].isApprox(Box(Point(.75, 0, 0), Point(1, 1, 1))));
  CHECK(three[1].isApprox(Box(Point(0, 0, 0), Point(.25, 1, 1))));
  CHECK(three[2].isApprox(Box(Point(.25, 0, 0), Point(.75, 1, 1))));

  // Two columns, the second with two shares, one above the other
  const auto grid = divide_box(unit, {{{0, 0, 0}, {1, 1, 1}}, {{9, 0, 0}, {1, 1, 1}}, {{9, 4, 0}, {1, 1, 1}}});
  CHECK(grid[0].isApprox(Box(Point(0, 0, 0), Point(.5, 1, 1))));
  CHECK(grid[1].isApprox(Box(Point(.5, 0, 0), Point(1, .5, 1))));
  CHECK(grid[2].isApprox(Box(Point(.5, .5, 0), Point(1, 1, 1))));

  // Concentric shares: both get the entire box
  for (const Box& box : divide_box(unit, {{{0, 0, 0}, {1, 1, 1}}, {{.1, 0, 0}, {2, 2, 2}}}))
    CHECK(box.isApprox(unit));
}

TEST_CASE("A rectangle of a sheet is sampled like a sheet")
{
  const Aligned_shape shape = align_shape(gate(0));
  const Sampled_part& panel = shape.parts[index_of(shape, 1)];
  CHECK(rectangle(panel, {0, 0}, {1, 1}).samples.isApprox(panel.samples));
  const Points quarter = rectangle(panel, {0, 0}, {.5, .5}).samples;
  CHECK(quarter.col(0).isApprox(panel.samples.col(0)));
  const Point corner = quarter.rightCols<1>();
  CHECK(corner.isApprox(panel.centroid));
}

TEST_CASE("A panel and bars: each bar has its third of the panel, which costs nothing; both ways")
{
  const Aligned_shape panel = align_shape(gate(0)), bars = align_shape(gate(3));
  const std::size_t g = panel.group_of[index_of(panel, 1)], h = bars.group_of[index_of(bars, 1)];
  const Group_label split = match_groups(panel, g, bars, h), merge = match_groups(bars, h, panel, g);
  CHECK(split.operation == Operation::SPLIT);
  CHECK(merge.operation == Operation::MERGE);
  REQUIRE(split.images[0].size() == 3);
  const auto check_third = [&](const Piece& piece, std::size_t bar) {
    const Sampled_part third = rectangle(panel.parts[piece.part], piece.low, piece.high);
    CHECK(third.centroid.isApprox(bars.parts[bar].centroid, 1e-9));
    const double width = third.samples.row(0).maxCoeff() - third.samples.row(0).minCoeff();
    CHECK(width == Approx(1 / 3.));
  };
  for (const Piece_image& image : split.images[0]) {
    check_third(image.source, image.target.part);
    CHECK(image.target.is_whole());
  }
  for (const auto& images : merge.images) {
    REQUIRE(images.size() == 1);
    check_third(images[0].target, images[0].source.part);
    CHECK(images[0].source.is_whole());
  }
  CHECK(overlap(split.images[0][0].source, split.images[0][0].source));
  CHECK(overlap(split.images[0][0].source, {split.images[0][0].source.part}));
  CHECK_FALSE(overlap(split.images[0][0].source, split.images[0][1].source));
}

TEST_CASE("The search splits a sheet into parts, and merges parts into a sheet, that lie on the sheet")
{
  Search_options options;
  options.method = Search_method::EXACT;
  options.both_directions = false;
  for (const bool forward : {true, false}) {
    const Correspondence c = find_correspondence(forward ? gate(0) : gate(3), forward ? gate(3) : gate(0), options);
    CHECK(c.groups[0].operation == Operation::MATCH);
    CHECK(c.groups[1].operation == (forward ? Operation::SPLIT : Operation::MERGE));
    // Small, since a bar is in the middle of its third of the panel, which changes its width only
    CHECK(c.terms.distortion < 0.08);
    CHECK(c.terms.connectedness < 0.05);
  }
}

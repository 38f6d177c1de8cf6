// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "aligned_graphs.h"
#include "deformed_parts.h"
#include "energy/cut_parts.h"

#include <catch2/catch.hpp>

#include <string>
#include <vector>

using namespace CGAL::Shape_correspondence;
using namespace hand_made;

namespace {

// A post of height 1, possibly in two or three pieces above each other, on a base.
Structural_graph post(const std::vector<double>& heights)
{
  Shape_structure shape;
  shape.parts.push_back(sheet("base", {-.2, 0, -.2}, {.4, 0, 0}, {0, 0, .4}));
  std::vector<std::size_t> members;
  for (std::size_t i = 0; i + 1 < heights.size(); ++i) {
    members.push_back(shape.parts.size());
    shape.parts.push_back(curve("piece " + std::to_string(i), {0, heights[i], 0}, {0, heights[i + 1], 0}));
    shape.contacts.push_back(contact(shape, members.back() - 1, members.back(), {0, heights[i], 0}));
  }
  return make_structural_graph(std::move(shape),
                               {group({0}), group(members, Symmetry_type::TRANSLATION, {0, heights[1], 0})});
}

} // namespace

TEST_CASE("Segments are equally long pieces")
{
  const Sampled_part whole = sampled(curve("a", {0, 0, 0}, {0, 3, 0}));
  for (int i = 0; i < 3; ++i) {
    const Sampled_part piece = segment(whole, i, 3);
    CHECK(piece.samples.cols() == samples_per_side);
    CHECK(piece.samples(1, 0) == Approx(i));
    CHECK(piece.samples(1, samples_per_side - 1) == Approx(i + 1));
    CHECK(piece.centroid.y() == Approx(i + .5));
  }
}

TEST_CASE("Cutting: a post turns into the pieces of another by their places, however it was drawn, and back")
{
  const Aligned_shape pieces = align_shape(post({0, 1 / 3., 2 / 3., 1}));
  const std::size_t to = pieces.group_of[index_of(pieces, 1)];
  for (const bool upwards : {true, false}) {
    const Aligned_shape whole = align_shape(post(upwards ? std::vector<double>{0, 1} : std::vector<double>{1, 0}));
    const std::size_t from = whole.group_of[index_of(whole, 1)];
    const Group_label split = match_groups(whole, from, pieces, to);
    CHECK(split.operation == Operation::SPLIT);
    const Group_label cut = cut_curves(whole, from, pieces, split);
    CHECK(cut.operation == Operation::CUT);
    REQUIRE(cut.images[0].size() == 3);
    for (const Piece_image& image : cut.images[0]) {
      CHECK(image.source.count == 3);
      CHECK(image.target.count == 1);
      // The segment is where its image is, so that fitting moves no sample
      const Sampled_part piece = segment(whole.parts[image.source.part], image.source.index, 3);
      CHECK(deform_to_fit(piece, pieces.parts[image.target.part]).isApprox(piece.samples, 1e-9));
    }

    const Group_label join = cut_curves(pieces, to, whole, match_groups(pieces, to, whole, from));
    CHECK(join.operation == Operation::JOIN);
    for (const auto& images : join.images) {
      REQUIRE(images.size() == 1);
      const Sampled_part piece = segment(whole.parts[images[0].target.part], images[0].target.index, 3);
      CHECK(piece.centroid.isApprox(pieces.parts[images[0].source.part].centroid, 1e-9));
    }
  }
}

TEST_CASE("Cutting: curves need not lie in a row")
{
  // A leg may be cut into two slats that stand side by side; the energy decides
  const Aligned_shape plain = align_shape(chair()), slats = align_shape(slatted_chair());
  const std::size_t leg_group = plain.group_of[index_of(plain, 2)];
  const std::size_t slat_group = slats.group_of[index_of(slats, 1)];
  const Group_label duplicate = match_groups(plain, leg_group, slats, slat_group);
  REQUIRE(duplicate.operation == Operation::DUPLICATE);
  const Group_label cut = cut_curves(plain, leg_group, slats, duplicate);
  CHECK(cut.operation == Operation::CUT);
  for (const auto& images : cut.images)
    for (const Piece_image& image : images)
      CHECK(image.source.count == int(images.size()));
}

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "aligned_graphs.h"
#include "structure/align_shapes.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace CGAL::Shape_correspondence;

TEST_CASE("Aligned shapes do not depend on position, scale, turning and part order")
{
  const Aligned_shape shape = align_shape(hand_made::chair());
  const Aligned_shape moved = align_shape(hand_made::moved(hand_made::chair(), 0.5, 3.7, {5, -2, 8}));
  REQUIRE(moved.parts.size() == shape.parts.size());
  CHECK(moved.original == shape.original);
  for (std::size_t i = 0; i < shape.parts.size(); ++i)
    CHECK((moved.parts[i].samples - shape.parts[i].samples).cwiseAbs().maxCoeff() < 1e-12);
}

TEST_CASE("Samples: e on a curve, e x e on a sheet; contacts know their nearest samples")
{
  const Aligned_shape shape = align_shape(hand_made::chair());
  for (std::size_t i = 0; i < shape.parts.size(); ++i)
    CHECK(shape.parts[i].samples.cols() == (shape.original[i] < 2 ? 36 : 6));
  REQUIRE(shape.contacts.size() == 5);
  for (const Aligned_shape::Contact& c : shape.contacts) {
    const Point a = shape.parts[c.parts[0]].samples.col(Eigen::Index(c.samples[0]));
    const Point b = shape.parts[c.parts[1]].samples.col(Eigen::Index(c.samples[1]));
    CHECK((a - b).norm() < 0.15); // at most one grid step of either sampling
    CHECK(c.parts[0] < c.parts[1]);
  }
}

TEST_CASE("Quarter turns: four of them lead back, to the bit")
{
  const Aligned_shape once = align_shape(hand_made::chair(), 1), none = align_shape(hand_made::chair());
  const auto find = [](const Aligned_shape& shape, std::size_t original) {
    return shape.parts[hand_made::index_of(shape, original)].samples;
  };
  // Counter-clockwise seen from above: front +z goes to +x
  CHECK(find(once, 2).col(0).isApprox(Point(.25, 0, -.25)));
  CHECK(find(align_shape(hand_made::chair(), 4), 2) == find(none, 2));
}

TEST_CASE("Symmetries of groups are turned and scaled with the shape")
{
  const Structural_graph graph = hand_made::moved(hand_made::slatted_chair(), 0.5, 3.7, {5, -2, 8});
  const Aligned_shape none = align_shape(graph), once = align_shape(graph, 1);
  const auto symmetry = [](const Aligned_shape& shape, std::size_t part) {
    return shape.group(shape.group_of[hand_made::index_of(shape, part)]).symmetry;
  };
  CHECK(symmetry(none, 1).direction.isApprox(Point(.2, 0, 0))); // translation between neighbouring slats
  CHECK(symmetry(once, 1).direction.isApprox(Point(0, 0, -.2)));
  CHECK(symmetry(none, 4).direction.isApprox(Point(1, 0, 0))); // normal of the mirror plane of the legs
  CHECK(symmetry(once, 4).direction.isApprox(Point(0, 0, -1)));
  CHECK(symmetry(none, 4).point.isZero(1e-12));
}

TEST_CASE("Alignments: nearest to the given orientation first")
{
  Shape_frame one_plane, no_plane;
  one_plane.mirror_x = true;
  CHECK(alignment_turns(one_plane, one_plane) == std::vector<int>{0, 2});
  CHECK(alignment_turns(one_plane, no_plane).size() == 4);

  for (int q = 0; q < 4; ++q) {
    Shape_frame turned = no_plane; // the frame is q quarter turns off the orientation of the file
    turned.axes = Eigen::AngleAxisd(q * EIGEN_PI / 2 + 0.3, Point::UnitY()).toRotationMatrix();
    CHECK(alignment_turns(no_plane, turned).front() == q);
  }
  // Rotating either shape in its file by less than 45 degrees changes nothing, nor does rotating both by any angle
  const auto turned_by = [](double degrees) {
    Shape_frame frame;
    frame.axes = Eigen::AngleAxisd(degrees * EIGEN_PI / 180, Point::UnitY()).toRotationMatrix();
    return frame;
  };
  for (const double a : {-40.0, 0.0, 40.0})
    for (const double b : {-40.0, 0.0, 40.0})
      CHECK(alignment_turns(turned_by(a), turned_by(b)).front() == 0);
  for (const double a : {60.0, 90.0, 170.0})
    CHECK(alignment_turns(turned_by(a), turned_by(a)).front() == 0);
  CHECK(alignment_turns(turned_by(0), turned_by(180)).front() == 2);
}

TEST_CASE("The remaining members of a group have their own solidity; a single one has no symmetry")
{
  const Aligned_shape table = align_shape(hand_made::table());
  const auto rest_without = [&](const std::vector<std::size_t>& legs, std::size_t leg) {
    const Aligned_shape shape = regrouped(table, {legs});
    return shape.group(shape.group_of[hand_made::index_of(shape, leg)]);
  };
  // Legs at the corners of a square: three of them have 3/4 of the volume, and a hull of half the volume
  const Part_group three = rest_without({1}, 2);
  CHECK(three.parts.size() == 3);
  CHECK(three.volume / three.hull_volume == Approx(.1 * 1.5));
  CHECK(three.symmetry.type == Symmetry_type::REFLECTION);
  CHECK(rest_without({1, 2, 3}, 4).symmetry.type == Symmetry_type::NONE);
  std::vector<char> is_kept(5, 1);
  is_kept[hand_made::index_of(table, 1)] = 0;
  const Aligned_shape fewer = restricted(table, is_kept);
  const Part_group& kept = fewer.group(fewer.group_of[hand_made::index_of(fewer, 2)]);
  CHECK(kept.volume / kept.hull_volume == Approx(.1 * 1.5));
}

TEST_CASE("Parts that cross each other are in the order of their samples, not in that of the file")
{
  const auto first_of = [](bool swapped) {
    Shape_structure shape;
    shape.parts = {hand_made::curve("up", {-1, 0, 0}, {1, 1, 0}), hand_made::curve("down", {-1, 1, 0}, {1, 0, 0})};
    if (swapped) std::swap(shape.parts[0], shape.parts[1]);
    const Structural_graph graph =
        make_structural_graph(std::move(shape), {hand_made::group({0}), hand_made::group({1})});
    return structure(graph).parts[align_shape(graph).original[0]].name;
  };
  CHECK(first_of(false) == first_of(true));
}

TEST_CASE("The most prominent parts are as many as asked for, in whole groups as far as they fit")
{
  for (const Structural_graph& graph : {hand_made::chair(), hand_made::slatted_chair(), hand_made::table()}) {
    const Aligned_shape shape = align_shape(graph);
    for (std::size_t count = 1; count <= shape.parts.size() + 1; ++count) {
      const std::vector<char> is_kept = most_prominent_parts(shape, count);
      CHECK(std::size_t(std::count(is_kept.begin(), is_kept.end(), 1)) == std::min(count, shape.parts.size()));
    }
  }
  // The top, then one of the four legs; the group of legs is taken as a whole only if all fit
  const Aligned_shape table = align_shape(hand_made::table());
  CHECK(most_prominent_parts(table, 2)[hand_made::index_of(table, 0)] == 1);
  // Seat, back and one of the two pairs of legs, as a whole
  const Aligned_shape chair = align_shape(hand_made::chair());
  const std::vector<char> four = most_prominent_parts(chair, 4);
  for (const Part_group& group : groups(chair))
    for (std::size_t part : group.parts)
      CHECK(four[part] == four[group.parts[0]]);
}

TEST_CASE("The most prominent part has the greatest volume, not the greatest hull")
{
  Structural_graph chair = hand_made::chair();
  structure(chair).parts[0].volume = 2, structure(chair).parts[0].hull_volume = 2;
  structure(chair).parts[1].volume = 1, structure(chair).parts[1].hull_volume = 4;
  const Aligned_shape shape = align_shape(chair);
  CHECK(most_prominent_parts(shape, 1)[hand_made::index_of(shape, 0)] == 1);
}

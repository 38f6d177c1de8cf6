// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "energy/Geotopo_transform.h"
#include "hand_made_graphs.h"

#include <catch2/catch.hpp>

#include <set>

using namespace CGAL::Shape_correspondence;
using namespace hand_made;

namespace {

Sampled_part sampled(const Part_abstraction& part)
{
  Sampled_part result;
  result.kind = part.is_sheet()          ? Sampled_part::Kind::SHEET
                : part.is_closed_curve() ? Sampled_part::Kind::CLOSED_CURVE
                                         : Sampled_part::Kind::CURVE;
  result.samples = sample(part, samples_per_side);
  result.centroid = result.samples.rowwise().mean();
  return result;
}

std::size_t index_of(const Aligned_shape& shape, std::size_t original)
{
  return std::size_t(std::find(shape.original.begin(), shape.original.end(), original) - shape.original.begin());
}

} // namespace

TEST_CASE("Curve to curve: ends matched by proximity, whatever the direction of either")
{
  const Sampled_part up = sampled(curve("a", {0, 0, 0}, {0, 1, 0}));
  const Sampled_part far = sampled(curve("b", {5, 3, 0}, {5.2, 5, 0})),
                     reversed = sampled(curve("b", {5.2, 5, 0}, {5, 3, 0}));
  CHECK(deform_to_fit(up, far).isApprox(far.samples));
  CHECK(deform_to_fit(up, reversed).isApprox(far.samples));
}

TEST_CASE("Sheet to sheet: corners keep their places under all eight layouts")
{
  const Sampled_part seat = sampled(sheet("a", {0, 0, 0}, {2, 0, 0}, {0, 0, 1}));
  const std::vector<Part_abstraction> layouts = {
      sheet("b", {9, 1, 0}, {3, 0, 0}, {0, 0, 1}),  sheet("b", {12, 1, 0}, {-3, 0, 0}, {0, 0, 1}),
      sheet("b", {9, 1, 1}, {3, 0, 0}, {0, 0, -1}), sheet("b", {12, 1, 1}, {-3, 0, 0}, {0, 0, -1}),
      sheet("b", {9, 1, 0}, {0, 0, 1}, {3, 0, 0}),  sheet("b", {12, 1, 0}, {0, 0, 1}, {-3, 0, 0}),
      sheet("b", {9, 1, 1}, {0, 0, -1}, {3, 0, 0}), sheet("b", {12, 1, 1}, {0, 0, -1}, {-3, 0, 0})};
  const Points expected = sampled(layouts[0]).samples;
  for (const Part_abstraction& layout : layouts)
    CHECK(deform_to_fit(seat, sampled(layout)).isApprox(expected));
}

TEST_CASE("Curve to sheet: the curve runs along the side it is nearest to in direction, and back")
{
  const Sampled_part slat = sampled(curve("a", {0, 0, 0}, {0, 1, 0}));
  const Sampled_part back = sampled(sheet("b", {-1, 0, 0}, {2, 0, 0}, {0, 1, 0}));
  const Points widened = deform_to_fit(slat, back);
  REQUIRE(widened.cols() == 36);
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      CHECK(widened(1, i * 6 + j) == Approx(i / 5.0)); // height keeps its place
  const Points narrowed = deform_to_fit(back, slat);
  for (int i = 0; i < 36; ++i)
    CHECK(narrowed(1, i) == Approx(back.samples(1, i)));
}

TEST_CASE("Closed curves start where they fit best")
{
  const auto ring = [](double first_angle, int direction) {
    Part_abstraction part;
    Curve curve;
    curve.closed = true;
    curve.points.resize(3, 12);
    for (int i = 0; i < 12; ++i) {
      const double a = first_angle + direction * i * EIGEN_PI / 6;
      curve.points.col(i) = Point(std::cos(a), std::sin(a), 0);
    }
    part.geometry = curve;
    return part;
  };
  const Sampled_part a = sampled(ring(0, 1));
  for (int step = 0; step < 6; ++step)
    for (int direction : {1, -1})
      CHECK((deform_to_fit(a, sampled(ring(step * EIGEN_PI / 3, direction))) - a.samples).norm() < 1e-9);
}

TEST_CASE("Members: one to one by place, then the left-over ones to the nearest")
{
  const Aligned_shape plain = align_shape(chair()), slats = align_shape(slatted_chair());
  const auto group_with = [](const Aligned_shape& shape, std::size_t original) {
    return shape.group_of[index_of(shape, original)];
  };

  const Group_label legs = match_members(plain, group_with(plain, 2), slats, group_with(slats, 4));
  CHECK(legs.operation == Operation::MATCH);
  for (std::size_t i = 0; i < 2; ++i) {
    REQUIRE(legs.images[i].size() == 1);
    const std::size_t from = plain.original[plain.groups[group_with(plain, 2)].parts[i]];
    CHECK(slats.original[legs.images[i][0].target.part] == from + 2); // left to left, right to right
  }

  const Group_label split = match_members(plain, group_with(plain, 1), slats, group_with(slats, 1));
  CHECK(split.operation == Operation::SPLIT);
  CHECK(split.images[0].size() == 3);
  CHECK(split.solidity_ratio == Approx(0.4));

  const Group_label merge = match_members(slats, group_with(slats, 1), plain, group_with(plain, 1));
  CHECK(merge.operation == Operation::MERGE);
  CHECK(merge.images.size() == 3);

  const Group_label duplicate = match_members(plain, group_with(plain, 2), slats, group_with(slats, 1));
  CHECK(duplicate.operation == Operation::DUPLICATE);
  std::set<std::size_t> taken;
  for (const auto& images : duplicate.images)
    for (const Image& image : images)
      taken.insert(image.target.part);
  CHECK(taken.size() == 3); // every target part is somebody's image
}

namespace {

// A post 1 high, or the same in two or three pieces on top of each other, on a base.
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

TEST_CASE("Cutting: a post turns into the pieces of another, in their order, and back")
{
  const Aligned_shape whole = align_shape(post({0, 1})), pieces = align_shape(post({0, 1 / 3., 2 / 3., 1}));
  const std::size_t from = whole.group_of[index_of(whole, 1)], to = pieces.group_of[index_of(pieces, 1)];
  const Group_label split = match_members(whole, from, pieces, to);
  CHECK(split.operation == Operation::SPLIT);
  const Group_label cut = cut_members(whole, from, pieces, split);
  CHECK(cut.operation == Operation::CUT);
  REQUIRE(cut.images[0].size() == 3);
  for (const Image& image : cut.images[0]) {
    CHECK(image.source.count == 3);
    CHECK(image.target.count == 1);
    // Fitted, a segment is the piece itself
    const Sampled_part piece = segment(whole.parts[image.source.part], image.source.index, 3);
    CHECK(deform_to_fit(piece, pieces.parts[image.target.part]).isApprox(piece.samples, 1e-9));
  }

  const Group_label join = cut_members(pieces, to, whole, match_members(pieces, to, whole, from));
  CHECK(join.operation == Operation::JOIN);
  for (const auto& images : join.images) {
    REQUIRE(images.size() == 1);
    const Sampled_part piece = segment(whole.parts[images[0].target.part], images[0].target.index, 3);
    CHECK(piece.centroid.isApprox(pieces.parts[images[0].source.part].centroid, 1e-9));
  }
}

TEST_CASE("Cutting: pieces that do not lie in a row are no segments of one curve")
{
  const Aligned_shape plain = align_shape(chair()), slats = align_shape(slatted_chair());
  const std::size_t leg_group = plain.group_of[index_of(plain, 2)];
  const std::size_t slat_group = slats.group_of[index_of(slats, 1)];
  const Group_label duplicate = match_members(plain, leg_group, slats, slat_group);
  CHECK(cut_members(plain, leg_group, slats, duplicate).operation == Operation::DUPLICATE);
}

TEST_CASE("Propagation: unmatched parts follow their contacts, members their generator")
{
  const Aligned_shape shape = align_shape(chair());
  const std::size_t seat = index_of(shape, 0);
  std::vector<char> matched(shape.groups.size(), 0);
  matched[shape.group_of[seat]] = 1;

  // The seat is widened by 0.1 on either side and raised by 0.2
  std::vector<std::array<Point, 2>> contact_displacement(shape.contacts.size());
  for (std::size_t c = 0; c < shape.contacts.size(); ++c)
    for (int side : {0, 1}) {
      const Point p =
          shape.parts[shape.contacts[c].parts[side]].samples.col(Eigen::Index(shape.contacts[c].samples[side]));
      contact_displacement[c][side] = Point(std::abs(p.x()) < .2 ? 0 : p.x() < 0 ? -.1 : .1, .2, 0);
    }
  Points displacement = Points::Zero(3, Eigen::Index(shape.parts.size()));
  Propagation propagation(shape);
  propagation(matched, contact_displacement, displacement);
  CHECK(displacement.col(Eigen::Index(index_of(shape, 2))).isApprox(Point(.1, .2, 0)));
  CHECK(displacement.col(Eigen::Index(index_of(shape, 3))).isApprox(Point(-.1, .2, 0)));
  CHECK(displacement.col(Eigen::Index(index_of(shape, 1))).isApprox(Point(0, .2, 0)));
}

TEST_CASE("Propagation: a chain between two matched ends settles to an even spread")
{
  // Five rods end to end; the outer two are moved, the others follow both sides
  Shape_structure shape;
  std::vector<Part_group> groups;
  for (int i = 0; i < 5; ++i) {
    shape.parts.push_back(curve(std::to_string(i), {double(i), 0, 0}, {i + 1., 1. * (i == 4), 0}));
    groups.push_back(group({std::size_t(i)}));
    if (i > 0) shape.contacts.push_back(contact(shape, std::size_t(i - 1), std::size_t(i), {double(i), 0, 0}));
  }
  const Aligned_shape chain = align_shape(make_structural_graph(std::move(shape), std::move(groups)));
  std::vector<char> matched(5, 0);
  matched[chain.group_of[index_of(chain, 0)]] = matched[chain.group_of[index_of(chain, 4)]] = 1;
  std::vector<std::array<Point, 2>> contact_displacement(chain.contacts.size());
  for (std::size_t c = 0; c < chain.contacts.size(); ++c)
    for (std::size_t side : {0, 1})
      contact_displacement[c][side] = Point(0, chain.original[chain.contacts[c].parts[side]] == 4 ? 0.4 : 0, 0);
  Points displacement = Points::Zero(3, 5);
  Propagation propagation(chain);
  propagation(matched, contact_displacement, displacement);
  for (std::size_t i : {1, 2, 3})
    CHECK(displacement(1, Eigen::Index(index_of(chain, i))) == Approx(0.1 * double(i)).margin(0.005));
}

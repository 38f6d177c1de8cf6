// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "energy/Structure_preservation.h"
#include "hand_made_graphs.h"

#include <catch2/catch.hpp>

#include <string>
#include <vector>

using namespace CGAL::Shape_correspondence;
using namespace hand_made;

TEST_CASE("Structure preservation: unmatched parts follow their contacts, members their generator")
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
  Structure_preservation preserve_structure(shape);
  preserve_structure(matched, contact_displacement, displacement);
  CHECK(displacement.col(Eigen::Index(index_of(shape, 2))).isApprox(Point(.1, .2, 0)));
  CHECK(displacement.col(Eigen::Index(index_of(shape, 3))).isApprox(Point(-.1, .2, 0)));
  CHECK(displacement.col(Eigen::Index(index_of(shape, 1))).isApprox(Point(0, .2, 0)));
}

TEST_CASE("Structure preservation: a chain between two matched ends settles to an even spread")
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
  Structure_preservation preserve_structure(chain);
  preserve_structure(matched, contact_displacement, displacement);
  for (std::size_t i : {1, 2, 3})
    CHECK(displacement(1, Eigen::Index(index_of(chain, i))) == Approx(0.1 * double(i)).margin(0.005));

  // Where parts were before has no say: with the one end matched all go with it, with none they go back
  matched[chain.group_of[index_of(chain, 0)]] = 0;
  preserve_structure(matched, contact_displacement, displacement);
  for (std::size_t i : {0, 1, 2, 3})
    CHECK(displacement(1, Eigen::Index(index_of(chain, i))) == Approx(0.4));
  preserve_structure(std::vector<char>(5, 0), contact_displacement, displacement);
  CHECK(displacement.isZero());
}

TEST_CASE("Structure preservation: a group follows the member that touches most, by the mean of what that one touches")
{
  // A mirror pair, the right one on two matched points, the left one on one
  const Aligned_shape shape = align_shape(
      point_graph({{-1, -1, 0}, {1, -1, -1}, {1, -1, 1}, {-1, 0, 0}, {1, 0, 0}}, {{0, 3}, {1, 4}, {2, 4}},
                  {group({0}), group({1}), group({2}), group({3, 4}, Symmetry_type::REFLECTION, Point::UnitX())}));
  std::vector<std::array<Point, 2>> contact_displacement(3, {Point::Zero(), Point::Zero()});
  contact_displacement[0][0] = Point(0, 0, .5);
  contact_displacement[1][0] = Point(.1, 0, 0);
  contact_displacement[2][0] = Point(.3, .2, 0);
  Points displacement = Points::Zero(3, 5);
  Structure_preservation preserve_structure(shape);
  preserve_structure({1, 1, 1, 0}, contact_displacement, displacement);
  CHECK(displacement.col(4).isApprox(Point(.2, .1, 0)));
  CHECK(displacement.col(3).isApprox(Point(-.2, .1, 0)));
}

TEST_CASE("Structure preservation: the members of a rotational group move turned about its axis")
{
  // Four points around a matched one. The first, to the left, is moved to the left, up and to the front; a quarter turn
  // about up takes (x, y, z) to (z, y, -x)
  const auto around = group({1, 2, 3, 4}, Symmetry_type::ROTATION, Point::UnitY());
  const Aligned_shape shape = align_shape(
      point_graph({{0, -1, 0}, {-1, 0, 0}, {0, 0, -1}, {0, 0, 1}, {1, 0, 0}}, {{0, 1}}, {group({0}), around}));
  const std::vector<std::array<Point, 2>> contact_displacement(1, {Point(-.1, .2, .05), Point::Zero()});
  Points displacement = Points::Zero(3, 5);
  Structure_preservation preserve_structure(shape);
  preserve_structure({1, 0}, contact_displacement, displacement);
  CHECK(displacement.col(1).isApprox(Point(-.1, .2, .05)));
  CHECK(displacement.col(2).isApprox(Point(-.05, .2, -.1)));
  CHECK(displacement.col(3).isApprox(Point(.05, .2, .1)));
  CHECK(displacement.col(4).isApprox(Point(.1, .2, -.05)));
}

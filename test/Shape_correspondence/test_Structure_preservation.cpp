// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "aligned_graphs.h"
#include "energy/Structure_preservation.h"

#include <catch2/catch.hpp>

#include <string>
#include <vector>

using namespace CGAL::Shape_correspondence;
using namespace hand_made;

TEST_CASE("Structure preservation: unmatched parts follow their contacts, members their generator")
{
  const Aligned_shape shape = align_shape(chair());
  const std::size_t seat = index_of(shape, 0);
  std::vector<char> matched(shape.number_of_groups(), 0);
  matched[shape.group_of[seat]] = 1;

  // The seat grows by 0.1 on either side and is raised by 0.2
  std::vector<std::array<Point, 2>> contact_displacement(shape.contacts.size());
  for (std::size_t c = 0; c < shape.contacts.size(); ++c)
    for (int side : {0, 1}) {
      const Point p =
          shape.parts[shape.contacts[c].parts[side]].samples.col(Eigen::Index(shape.contacts[c].samples[side]));
      contact_displacement[c][side] = Point(std::abs(p.x()) < .2 ? 0 : p.x() < 0 ? -.1 : .1, .2, 0);
    }
  std::vector<Part_motion> motions(shape.parts.size());
  Structure_preservation preserve_structure(shape);
  preserve_structure(matched, contact_displacement, motions);
  CHECK(motions[index_of(shape, 2)].shift.isApprox(Point(.1, .2, 0)));
  CHECK(motions[index_of(shape, 3)].shift.isApprox(Point(-.1, .2, 0)));
  CHECK(motions[index_of(shape, 1)].shift.isApprox(Point(0, .2, 0)));
}

TEST_CASE("Structure preservation: a chain between two matched ends settles to an even spread")
{
  // Five rods end to end; the outer two are moved, the inner ones follow both
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
  std::vector<Part_motion> motions(5);
  Structure_preservation preserve_structure(chain);
  preserve_structure(matched, contact_displacement, motions);
  // Displacements grow from 0 to 0.4 over the three inner rods; ends of neighbours stay together
  for (std::size_t i : {1, 2, 3}) {
    const Part_motion& motion = motions[index_of(chain, i)];
    const Point half(.5, 0, 0); // from the centre of a rod to its end
    const double left = (motion.shift - motion.stretch * half).y(), right = (motion.shift + motion.stretch * half).y();
    CHECK(left == Approx(i == 1 ? 0 : .1 * double(i) - .05).margin(0.01));
    CHECK(right == Approx(i == 3 ? .4 : .1 * double(i) + .05).margin(0.01));
  }

  // Previous displacements do not matter: with only one end matched, all parts follow it; with none, all rest
  matched[chain.group_of[index_of(chain, 0)]] = 0;
  preserve_structure(matched, contact_displacement, motions);
  for (std::size_t i : {0, 1, 2, 3})
    CHECK(motions[index_of(chain, i)].shift.isApprox(Point(0, .4, 0)));
  preserve_structure(std::vector<char>(5, 0), contact_displacement, motions);
  for (const Part_motion& motion : motions)
    CHECK(motion == Part_motion());
}

TEST_CASE("Structure preservation: a longer chain needs several rounds")
{
  // Seven points in a row, the last of which is moved by 0.6
  std::vector<Point> places;
  std::vector<std::array<std::size_t, 2>> contacts;
  for (std::size_t i = 0; i < 7; ++i) {
    places.emplace_back(double(i), 0, 0);
    if (i > 0) contacts.push_back({i - 1, i});
  }
  const Aligned_shape chain = align_shape(point_graph(places, contacts));
  std::vector<std::array<Point, 2>> contact_displacement(6, {Point::Zero(), Point::Zero()});
  contact_displacement[5][1] = Point(0, .6, 0);
  std::vector<Part_motion> motions(7);
  Structure_preservation preserve_structure(chain);
  preserve_structure({1, 0, 0, 0, 0, 0, 1}, contact_displacement, motions);
  for (std::size_t i : {2, 3, 4})
    CHECK(motions[i].shift.y() == Approx(.1 * double(i)).margin(0.01));
}

TEST_CASE("Structure preservation: a bar is stretched between the legs that it spans, its mirror image alike")
{
  // Bars at the back and at the front each connect a left and a right leg. The legs are matched; all move outwards by
  // 0.1 in x, and in z the left ones by 0.4, the right ones by 0.2
  Shape_structure shape;
  for (double z : {-.5, .5}) {
    const std::size_t first = shape.parts.size();
    shape.parts.push_back(curve("left", {-.5, 0, z}, {-.5, 1, z}));
    shape.parts.push_back(curve("right", {.5, 0, z}, {.5, 1, z}));
    shape.parts.push_back(curve("bar", {-.5, .4, z}, {.5, .4, z}));
    shape.contacts.push_back(contact(shape, first, first + 2, {-.5, .4, z}));
    shape.contacts.push_back(contact(shape, first + 1, first + 2, {.5, .4, z}));
  }
  const Aligned_shape legs =
      align_shape(make_structural_graph(std::move(shape), {group({0}), group({1}), group({3}), group({4}),
                                                           group({2, 5}, Symmetry_type::REFLECTION, Point::UnitZ())}));
  std::vector<char> matched(legs.number_of_groups(), 1);
  const std::size_t bars = legs.group_of[index_of(legs, 2)];
  matched[bars] = 0;
  std::vector<std::array<Point, 2>> contact_displacement(legs.contacts.size());
  for (std::size_t c = 0; c < legs.contacts.size(); ++c)
    for (std::size_t side : {0, 1}) {
      const std::size_t part = legs.contacts[c].parts[side];
      const double x = legs.parts[part].centroid.x(), z = legs.parts[part].centroid.z();
      contact_displacement[c][side] = Point(x < 0 ? -.1 : .1, 0, (x < 0 ? .4 : .2) * (z < 0 ? -1 : 1));
    }
  std::vector<Part_motion> motions(legs.parts.size());
  Structure_preservation preserve_structure(legs);
  preserve_structure(matched, contact_displacement, motions);
  // Least squares, from squared distances from the centre: their sum for the contact points is 2 · 0.25, their mean for
  // the samples, which are at ±.1, ±.3 and ±.5, is .35 / 3
  const double slope = .1 / (.5 + Structure_preservation::stiffness * .35 / 3);
  for (std::size_t bar : {2, 5}) {
    const Part_motion& motion = motions[index_of(legs, bar)];
    CHECK(motion.shift.isApprox(Point(0, 0, bar == 2 ? -.3 : .3)));
    Eigen::Matrix3d stretch = Eigen::Matrix3d::Zero();
    stretch(0, 0) = slope;
    stretch(2, 0) = bar == 2 ? slope : -slope;
    CHECK((motion.stretch - stretch).cwiseAbs().maxCoeff() < 1e-6);
  }
}

TEST_CASE("Structure preservation: a bar whose contacts are all on one side of its middle turns about their mean")
{
  // Contacts at 0.6 and at the end, 1, which is raised by 0.2: the bar turns about 0.8, midway, and its centre, 0.5,
  // goes down. Squared distances: sum for the contact points from 0.8: 2 * 0.04, mean for samples from 0.5: .35 / 3
  Shape_structure shape;
  shape.parts = {curve("bar", {0, 1, 0}, {1, 1, 0}), curve("at", {.6, 0, 0}, {.6, 1, 0}),
                 curve("end", {1, 0, 0}, {1, 1, 0})};
  shape.contacts = {contact(shape, 0, 1, {.6, 1, 0}), contact(shape, 0, 2, {1, 1, 0})};
  const Aligned_shape posts =
      align_shape(make_structural_graph(std::move(shape), {group({0}), group({1}), group({2})}));
  const std::size_t bar = index_of(posts, 0);
  std::vector<char> matched(3, 1);
  matched[posts.group_of[bar]] = 0;
  std::vector<std::array<Point, 2>> contact_displacement(2, {Point::Zero(), Point::Zero()});
  contact_displacement[1][0] = contact_displacement[1][1] = Point(0, .2, 0);
  std::vector<Part_motion> motions(3);
  Structure_preservation preserve_structure(posts);
  preserve_structure(matched, contact_displacement, motions);
  const double slope = .2 * .2 / (2 * .04 + Structure_preservation::stiffness * .35 / 3);
  CHECK(motions[bar].stretch(1, 0) == Approx(slope));
  CHECK(motions[bar].shift.isApprox(Point(0, .1 - .3 * slope, 0)));
}

TEST_CASE("Structure preservation: a group follows the member that touches most, by the mean of what that one touches")
{
  // A mirror pair of points: below the right one are two matched points, below the left one is one; on top of each is
  // an unmatched one
  const Aligned_shape shape =
      align_shape(point_graph({{-1, -1, 0}, {1, -1, -1}, {1, -1, 1}, {-1, 0, 0}, {1, 0, 0}, {-1, 1, 0}, {1, 1, 0}},
                              {{0, 3}, {1, 4}, {2, 4}, {3, 5}, {4, 6}},
                              {group({0}), group({1}), group({2}),
                               group({3, 4}, Symmetry_type::REFLECTION, Point::UnitX()), group({5}), group({6})}));
  std::vector<std::array<Point, 2>> contact_displacement(5, {Point::Zero(), Point::Zero()});
  contact_displacement[0][0] = Point(0, 0, .5);
  contact_displacement[1][0] = Point(.1, 0, 0);
  contact_displacement[2][0] = Point(.3, .2, 0);
  std::vector<Part_motion> motions(7);
  Structure_preservation preserve_structure(shape);
  preserve_structure({1, 1, 1, 0, 0, 0}, contact_displacement, motions);
  for (std::size_t right : {4, 6}) {
    CHECK(motions[right].shift.isApprox(Point(.2, .1, 0)));
    CHECK(motions[right - 1].shift.isApprox(Point(-.2, .1, 0)));
  }
}

TEST_CASE("Structure preservation: the members of a rotational group move turned about its axis")
{
  // Four points around a matched one. The first, on the left, is moved to the left, up and to the front; a quarter turn
  // about the up axis maps (x, y, z) to (z, y, -x)
  const auto around = group({1, 2, 3, 4}, Symmetry_type::ROTATION, Point::UnitY());
  const Aligned_shape shape = align_shape(
      point_graph({{0, -1, 0}, {-1, 0, 0}, {0, 0, -1}, {0, 0, 1}, {1, 0, 0}}, {{0, 1}}, {group({0}), around}));
  const std::vector<std::array<Point, 2>> contact_displacement(1, {Point(-.1, .2, .05), Point::Zero()});
  std::vector<Part_motion> motions(5);
  Structure_preservation preserve_structure(shape);
  preserve_structure({1, 0}, contact_displacement, motions);
  CHECK(motions[1].shift.isApprox(Point(-.1, .2, .05)));
  CHECK(motions[2].shift.isApprox(Point(-.05, .2, -.1)));
  CHECK(motions[3].shift.isApprox(Point(.05, .2, .1)));
  CHECK(motions[4].shift.isApprox(Point(.1, .2, -.05)));
}

TEST_CASE("Structure preservation: an orbit of two mirror planes is mirrored in both")
{
  const Aligned_shape whole = align_shape(table());
  std::vector<char> is_kept(whole.parts.size(), 1);
  // The leg that is removed together with leg 4; 0: all four stay. The others must move as if none were removed
  const int missing = GENERATE(0, 1, 2, 3);
  if (missing > 0) is_kept[index_of(whole, std::size_t(missing))] = is_kept[index_of(whole, 4)] = 0;
  const Aligned_shape shape = restricted(whole, is_kept);
  // The top of the table grows by 0.2 on each side and by 0.3 at the front and back
  std::vector<char> matched(2, 0);
  matched[shape.group_of[index_of(shape, 0)]] = 1;
  std::vector<std::array<Point, 2>> contact_displacement(shape.contacts.size());
  for (std::size_t c = 0; c < shape.contacts.size(); ++c)
    for (std::size_t side : {0, 1}) {
      const Point p =
          shape.parts[shape.contacts[c].parts[side]].samples.col(Eigen::Index(shape.contacts[c].samples[side]));
      contact_displacement[c][side] = Point(p.x() < 0 ? -.2 : .2, 0, p.z() < 0 ? -.3 : .3);
    }
  std::vector<Part_motion> motions(shape.parts.size());
  Structure_preservation preserve_structure(shape);
  preserve_structure(matched, contact_displacement, motions);
  for (std::size_t leg : shape.group(shape.group_of[index_of(shape, missing == 1 ? 2 : 1)]).parts) {
    const Point at = shape.parts[leg].centroid;
    CHECK(motions[leg].shift.isApprox(Point(at.x() < 0 ? -.2 : .2, 0, at.z() < 0 ? -.3 : .3)));
  }
}

TEST_CASE("Structure preservation: with hard contacts, an unmatched part moves exactly with its contact points")
{
  Shape_structure shape;
  shape.parts = {curve("bar", {0, 1, 0}, {1, 1, 0}), curve("start", {0, 0, 0}, {0, 1, 0}),
                 curve("end", {1, 0, 0}, {1, 1, 0})};
  shape.contacts = {contact(shape, 0, 1, {0, 1, 0}), contact(shape, 0, 2, {1, 1, 0})};
  const Aligned_shape posts =
      align_shape(make_structural_graph(std::move(shape), {group({0}), group({1}), group({2})}));
  const std::size_t bar = index_of(posts, 0);
  std::vector<char> matched(3, 1);
  matched[posts.group_of[bar]] = 0;
  std::vector<std::array<Point, 2>> contact_displacement(2, {Point::Zero(), Point::Zero()});
  for (std::size_t c : {0, 1})
    if (posts.original[posts.contacts[c].parts[0]] == 2 || posts.original[posts.contacts[c].parts[1]] == 2)
      contact_displacement[c] = {Point(.4, .2, 0), Point(.4, .2, 0)};
  const auto end_of_bar = [&](bool is_hard) {
    std::vector<Part_motion> motions(3);
    Structure_preservation preserve_structure(posts, is_hard);
    preserve_structure(matched, contact_displacement, motions);
    return Point(motions[bar].shift + motions[bar].stretch * Point(.5, 0, 0));
  };
  CHECK(end_of_bar(true).isApprox(Point(.4, .2, 0), 1e-6));
  CHECK((end_of_bar(false) - Point(.4, .2, 0)).norm() > 1e-3);
}

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "box_shapes.h"
#include "generated_shapes.h"
#include "shape/triangle_distance.h"

#include <CGAL/Shape_correspondence/detect_contacts.h>

#include <catch2/catch.hpp>

using namespace box_shapes;

namespace {

struct Found
{
  std::set<Names> pairs;
  std::vector<Contact> contacts;
  std::vector<Part_abstraction> parts;
  std::vector<std::string> warnings;
};

Found contacts_of(const Segmented_shape& shape, double tolerance = 0.02)
{
  Found found;
  found.parts = quick_parts(shape);
  Contact_options options;
  options.tolerance = tolerance;
  found.contacts = detect_contacts(shape, found.parts, frame_of(found.parts), options, found.warnings);
  for (const Contact& contact : found.contacts)
    found.pairs.insert({found.parts[contact.parts[0]].name, found.parts[contact.parts[1]].name});
  return found;
}

const std::set<Names> TABLE_PAIRS = {{"leg_1", "plate"}, {"leg_2", "plate"}, {"leg_3", "plate"}, {"leg_4", "plate"}};
const std::set<Names> CHAIR_PAIRS = {{"seat", "front_leg_l"},
                                     {"seat", "front_leg_r"},
                                     {"seat", "back_leg_l"},
                                     {"seat", "back_leg_r"},
                                     {"stretcher_l", "back_leg_l"},
                                     {"stretcher_r", "back_leg_r"},
                                     {"stretcher_l", "front_leg_l"},
                                     {"stretcher_r", "front_leg_r"},
                                     {"rail", "back_leg_l"},
                                     {"rail", "back_leg_r"},
                                     {"rail", "slat_0"},
                                     {"rail", "slat_1"},
                                     {"rail", "slat_2"},
                                     {"rail", "slat_3"},
                                     {"rail", "slat_4"},
                                     {"seat", "slat_0"},
                                     {"seat", "slat_1"},
                                     {"seat", "slat_2"},
                                     {"seat", "slat_3"},
                                     {"seat", "slat_4"}};

Segmented_shape two_boxes(double gap)
{
  Segmented_shape shape("boxes");
  shape.add_part("a", box({0, 0.5, 0}, {1, 1, 1}));
  shape.add_part("b", box({1 + gap, 0.5, 0}, {1, 1, 1}));
  return shape;
}

} // namespace

TEST_CASE("Contacts of shapes made of boxes are those of their construction")
{
  const Found on_table = contacts_of(table());
  CHECK(on_table.pairs == TABLE_PAIRS);
  CHECK(on_table.contacts.size() == TABLE_PAIRS.size());
  CHECK(on_table.warnings.empty());
  CHECK(contacts_of(chair()).pairs == CHAIR_PAIRS);
}

TEST_CASE("Contacts are where the parts touch")
{
  const Found found = contacts_of(table());
  for (const Contact& contact : found.contacts) {
    CHECK(contact.parts[0] == 0);
    const Part_abstraction& leg = found.parts[contact.parts[1]];
    const Point on_leg = evaluate(leg, contact.parameters[1]),
                on_plate = evaluate(found.parts[0], contact.parameters[0]);
    CHECK(on_leg.y() == Approx(0.95).margin(0.02));
    CHECK(on_plate.x() == Approx(on_leg.x()).margin(0.02));
  }
}

TEST_CASE("Contacts do not depend on pose, scale and order of parts")
{
  std::mt19937 random(4);
  for (int i = 0; i < 5; ++i) {
    CAPTURE(i);
    const Segmented_shape shape = chair();
    CHECK(contacts_of(moved(shape, random_motion(random), random_order(shape.parts().size(), random))).pairs ==
          CHAIR_PAIRS);
  }
}

TEST_CASE("Contacts are sorted")
{
  const std::vector<Contact> contacts = contacts_of(chair()).contacts;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    CHECK(contacts[i].parts[0] < contacts[i].parts[1]);
    if (i > 0) CHECK(contacts[i - 1].parts < contacts[i].parts);
  }
}

TEST_CASE("A gap within the tolerance is a contact, a wider one is joined with a warning")
{
  CHECK(contacts_of(two_boxes(0.03)).warnings.empty());
  const Found joined = contacts_of(two_boxes(0.1));
  REQUIRE(joined.contacts.size() == 1);
  REQUIRE(joined.warnings.size() == 1);
  CHECK(joined.warnings[0].find("'a'") != std::string::npos);
  CHECK(joined.warnings[0].find("'b'") != std::string::npos);
  CHECK(joined.warnings[0].find("3.9 %") != std::string::npos); // gap over diagonal: 0.1 / sqrt(2.1² + 1 + 1)
  CHECK(contacts_of(two_boxes(0.1), 0.05).warnings.empty());
  CHECK(contacts_of(two_boxes(-0.3)).warnings.empty());
}

TEST_CASE("Pieces are joined by their closest pairs")
{
  Segmented_shape shape("three boxes");
  shape.add_part("a", box({0, 0.5, 0}, {1, 1, 1}));
  shape.add_part("c", box({3, 0.5, 0}, {1, 1, 1}));
  shape.add_part("b", box({1.4, 0.5, 0}, {1, 1, 1}));
  const Found found = contacts_of(shape);
  CHECK(found.pairs == std::set<Names>{{"a", "b"}, {"b", "c"}});
  CHECK(found.warnings.size() == 2);
}

TEST_CASE("A part inside another touches it")
{
  Segmented_shape shape("box in a box");
  shape.add_part("outer", box({0, 0.5, 0}, {1, 1, 1}));
  shape.add_part("inner", box({0, 0.5, 0}, {0.4, 0.4, 0.4}));
  const Found found = contacts_of(shape);
  CHECK(found.contacts.size() == 1);
  CHECK(found.warnings.empty());
}

TEST_CASE("A gap within the tolerance is a contact, also beside a part that touches both sides")
{
  Segmented_shape shape("two boxes on a board");
  shape.add_part("board", box({0.5, -0.05, 0}, {2.2, 0.1, 1}));
  shape.add_part("a", box({0, 0.5, 0}, {1, 1, 1}));
  shape.add_part("b", box({1.03, 0.5, 0}, {1, 1, 1}));
  CHECK(contacts_of(shape).pairs == std::set<Names>{{"board", "a"}, {"board", "b"}, {"a", "b"}});
}

TEST_CASE("Contacts of the models in data are the parts that a brute-force distance finds near, in any pose")
{
  std::mt19937 random(6);
  for (const auto& model : generated_shapes::gen::models()) {
    INFO(model.name);
    const auto assembly = model.make();
    std::set<Names> near;
    for (const auto& pair : assembly.near_parts(0.02))
      near.insert({assembly.parts[pair.parts[0]].name, assembly.parts[pair.parts[1]].name});
    const Segmented_shape shape = generated_shapes::shape_of(assembly);
    const Found found = contacts_of(shape);
    CHECK(found.pairs == near);
    CHECK(found.contacts.size() == near.size());
    CHECK(contacts_of(moved(shape, random_motion(random), random_order(shape.parts().size(), random))).pairs == near);
  }
}

TEST_CASE("An arm that touches the back twice has a contact of two regions, the larger one first")
{
  // A C-shaped arm: a bar at a distance from the back, and two bars that reach it, the upper one thicker
  const Part_mesh pieces[] = {box({0.3, 1, 0}, {0.05, 0.6, 0.05}), box({0.15, 0.75, 0}, {0.3, 0.04, 0.05}),
                              box({0.15, 1.25, 0}, {0.3, 0.08, 0.05})};
  Part_mesh arm = pieces[0];
  for (int i = 1; i < 3; ++i) {
    const Eigen::Index points = arm.points.cols(), triangles = arm.triangles.cols();
    arm.points.conservativeResize(3, points + pieces[i].points.cols());
    arm.points.rightCols(pieces[i].points.cols()) = pieces[i].points;
    arm.triangles.conservativeResize(3, triangles + pieces[i].triangles.cols());
    arm.triangles.rightCols(pieces[i].triangles.cols()) = pieces[i].triangles.array() + static_cast<int>(points);
  }
  Segmented_shape shape("back with an arm");
  shape.add_part("back", box({-0.02, 1, 0}, {0.04, 1, 0.1}));
  shape.add_part("arm", arm);
  const Found found = contacts_of(shape);
  REQUIRE(found.contacts.size() == 1);
  REQUIRE(found.contacts[0].further.size() == 1);
  const auto height = [&](const Contact::Parameters& parameters) {
    return evaluate(found.parts[0], parameters[0]).y();
  };
  const double one = height(found.contacts[0].parameters), other = height(found.contacts[0].further[0]);
  CHECK(one == Approx(1.25).margin(0.02));
  CHECK(other == Approx(0.75).margin(0.02));
  for (const Contact& contact : contacts_of(chair()).contacts)
    CHECK(contact.further.empty());
}

TEST_CASE("Triangles of one plane do not cross, whatever rounding makes of it")
{
  using internal::contacts::Triangle;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(0, 1);
  for (int i = 0; i < 1000; ++i) {
    const Point axis = Point(place(random), place(random), place(random)).normalized();
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(place(random), axis).toRotationMatrix();
    const auto corner = [&](double x) { return Point(turn * Point(x + place(random), place(random), 0)); };
    const Triangle one = {corner(0), corner(0), corner(0)}, other = {corner(2), corner(2), corner(2)};
    internal::contacts::Closest_pair found;
    internal::contacts::improve_by_triangles(one, other, found, found.squared);
    REQUIRE(found.squared >= 0.999);
    REQUIRE(!internal::contacts::are_within(one, other, 0.9));
  }
}

TEST_CASE("The point of a triangle nearest to a point, also of needles and of triangles without area")
{
  using internal::contacts::Triangle;
  const auto nearest = internal::contacts::nearest_on_triangle;
  const Triangle right = {Point(0, 0, 0), Point(4, 0, 0), Point(0, 2, 0)};
  CHECK(nearest({-1, -1, 1}, right) == Point(0, 0, 0));
  CHECK(nearest({6, -1, 1}, right) == Point(4, 0, 0));
  CHECK(nearest({-1, 5, 1}, right) == Point(0, 2, 0));
  CHECK(nearest({1, -3, 0}, right).isApprox(Point(1, 0, 0)));
  CHECK(nearest({-2, 1, 3}, right).isApprox(Point(0, 1, 0)));
  CHECK(nearest({3, 3, -2}, right).isApprox(Point(2, 1, 0)));
  CHECK(nearest({1, 0.5, -7}, right).isApprox(Point(1, 0.5, 0)));
  // The nearest point: no point of a side is nearer, and the plane through it with normal p - found has the triangle on
  // its far side
  std::mt19937 random(7);
  std::normal_distribution<double> place;
  const auto anywhere = [&] { return Point(place(random), place(random), place(random)); };
  for (double flatness : {1., 1e-3, 1e-5, 1e-8, 1e-13, 0.})
    for (int i = 0; i < 2000; ++i) {
      Triangle t = {anywhere(), anywhere(), {}};
      t[2] = t[0] + place(random) * (t[1] - t[0]) + flatness * anywhere();
      std::swap(t[2], t[std::size_t(i % 3)]);
      const Point p = anywhere(), found = nearest(p, t);
      CAPTURE(flatness, i);
      for (std::size_t k = 0; k < 3; ++k) {
        const Point side = internal::contacts::nearest_on_segment(p, t[k], t[(k + 1) % 3]);
        REQUIRE((found - p).norm() <= (side - p).norm() + 1e-14);
        REQUIRE((p - found).dot(t[k] - found) <= 1e-7);
      }
    }
}

TEST_CASE("A shape of which too many pairs of parts touch is refused")
{
  constexpr int copies = 320; // they have 51 040 pairs
  Segmented_shape shape("heap");
  for (int i = 0; i < copies; ++i)
    shape.add_part("part_" + std::to_string(i), box({1e-4 * i, 0.5, 0}, {1, 1, 1}));
  CHECK_THROWS_WITH(contacts_of(shape), Catch::Matchers::Contains("more than 50000 pairs of its parts touch"));
}

TEST_CASE("Contacts are found without meshes, by what abstractions tell of the parts")
{
  std::vector<Part_abstraction> parts = quick_parts(chair());
  for (Part_abstraction& part : parts) {
    const Point size = part.hull.rowwise().maxCoeff() - part.hull.rowwise().minCoeff();
    part.volume = size.prod();
  }
  const Point u(0.5, 0, 0), v(0, 0, 0.46), corner(-0.25, 0.45, -0.23);
  Sheet seat;
  seat.rows = seat.cols = 2;
  seat.points.resize(3, 4);
  seat.points << corner, corner + v, corner + u, corner + u + v;
  parts[0].geometry = seat;
  std::vector<std::string> warnings;
  std::set<Names> pairs;
  for (const Contact& contact : detect_contacts(parts, frame_of(parts), {}, warnings))
    pairs.insert({parts[contact.parts[0]].name, parts[contact.parts[1]].name});
  CHECK(warnings.empty());
  for (const Names& expected : CHAIR_PAIRS) {
    CAPTURE(*expected.begin(), *expected.rbegin());
    CHECK(pairs.count(expected) == 1);
  }
  CHECK(pairs.count({"front_leg_l", "front_leg_r"}) == 0);
  CHECK(pairs.count({"stretcher_l", "rail"}) == 0);
}

TEST_CASE("With the option closest_points, a contact is at the closest pair of points")
{
  // A board that leans away from a box, with a gap of 0.01 at its lower edge, at height 0.2
  Part_mesh board = box({0, 0, 0}, {.2, 2, 1});
  board.points = Eigen::AngleAxisd(-EIGEN_PI / 9, Point::UnitZ()).toRotationMatrix() * board.points;
  const Eigen::Index corner = [&] {
    Eigen::Index nearest;
    board.points.row(0).minCoeff(&nearest);
    return nearest;
  }();
  const Point shift = Point(.51, .2, 0) - Point(board.points(0, corner), board.points(1, corner), 0);
  board.points.colwise() += shift;
  Segmented_shape shape("box and board");
  shape.add_part("a", box({0, 0.5, 0}, {1, 1, 1}));
  shape.add_part("b", board);
  const std::vector<Part_abstraction> parts = quick_parts(shape);
  const auto height_on_board = [&](bool closest_points) {
    Contact_options options;
    options.closest_points = closest_points;
    std::vector<std::string> warnings;
    const std::vector<Contact> contacts = detect_contacts(shape, parts, frame_of(parts), options, warnings);
    REQUIRE(contacts.size() == 1);
    return evaluate(parts[1], contacts[0].parameters[1]).y();
  };
  CHECK(height_on_board(true) < height_on_board(false) - 0.01);
}

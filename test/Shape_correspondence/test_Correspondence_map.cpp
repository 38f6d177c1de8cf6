// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "box_shapes.h"
#include "boxed_graphs.h"
#include "hand_made_graphs.h"

#include <CGAL/Shape_correspondence/Correspondence_map.h>

#include <catch2/catch.hpp>

// Maps between curves and sheets of shapes made of boxes, whose results are known.

using namespace box_shapes;
using namespace boxed_graphs;

TEST_CASE("A shape is mapped to itself by the identity")
{
  const Segmented_shape shape = chair();
  const Structural_graph graph = graph_of(shape);
  const Correspondence_map map(graph, graph, identity(shape));
  for (std::size_t part = 0; part < shape.parts().size(); ++part)
    for (double u : {0., 0.3, 1.})
      for (double v : {0., 0.8}) {
        const Eigen::Vector2d parameter(u, structure(graph).parts[part].is_sheet() ? v : 0);
        const auto images = map({part, parameter});
        REQUIRE(images.size() == 1);
        CHECK(images[0].part == part);
        CHECK((images[0].parameter - parameter).norm() < 1e-9);
      }
}

TEST_CASE("A plate that splits into laths is covered by them, each by its third")
{
  const Segmented_shape source = knobbed_plate(), target = three_laths();
  const Structural_graph from = graph_of(source), to = graph_of(target);
  REQUIRE(structure(from).parts[0].is_sheet());
  const Correspondence_map map(from, to, pairing({{0, 0}, {0, 1}, {0, 2}}));
  std::array<int, 3> hits = {0, 0, 0};
  Point before = Point::Zero();
  std::size_t part_before = 3;
  constexpr int n = 300;
  const bool along_u = std::abs(evaluate(structure(from).parts[0], {1, 0.5}).x()) > 0.5;
  for (int i = 0; i < n; ++i) {
    const double x = (i + 0.5) / n;
    const Eigen::Vector2d parameter = along_u ? Eigen::Vector2d(x, 0.3) : Eigen::Vector2d(0.3, x);
    const auto images = map({0, parameter});
    REQUIRE(images.size() == 1);
    ++hits[images[0].part];
    // The laths are in the place of the plate, so that a point and its image are near each other
    const Point place = evaluate(structure(from).parts[0], parameter);
    const Point image = evaluate(structure(to).parts[images[0].part], images[0].parameter);
    CHECK(std::abs(place.x() - image.x()) < 0.06);
    CHECK(std::abs(place.z() - image.z()) < 0.02);
    if (part_before == images[0].part) CHECK((image - before).norm() < 2 * 1.2 / n);
    before = image;
    part_before = images[0].part;
    // The inverse map returns to the point of the plate
    bool returns = false;
    for (const Part_parameter& back : map.inverse()(images[0]))
      returns = returns || (back.part == 0 && (back.parameter - parameter).norm() < 1e-9);
    CHECK(returns);
  }
  for (int count : hits)
    CHECK(count == n / 3);
  CHECK(map.inverse()({1, {0.5, 0.5}}).size() == 1);
}

TEST_CASE("A curve that is cut becomes segments; its points between two segments have both as images")
{
  Segmented_shape source = knobbed_box({0.1, 1, 0.1}), target("cut");
  target.add_part("low", box({0, 0.25, 0}, {0.1, 0.5, 0.1}));
  target.add_part("high", box({0, 0.75, 0}, {0.1, 0.5, 0.1}));
  const Structural_graph from = graph_of(source), to = graph_of(target);
  const Correspondence_map map(from, to, pairing({{0, 0}, {0, 1}}));
  for (double t : {0.1, 0.4, 0.7, 0.9}) {
    const auto images = map({0, {t, 0}});
    REQUIRE(images.size() == 1);
    const Point place = evaluate(structure(from).parts[0], {t, 0});
    CHECK((evaluate(structure(to).parts[images[0].part], images[0].parameter) - place).norm() < 1e-6);
  }
  CHECK(map({0, {0.5, 0}}).size() == 2);
}

TEST_CASE("A ring is mapped to a ring whose curve has the opposite direction, every point to its place")
{
  const auto graph_of_ring = [](double sign) {
    Shape_structure shape;
    shape.parts = {hand_made::ring("ring", {0, 0.5, 0}, {0.4, 0, 0}, {0, 0, sign * 0.3}),
                   hand_made::curve("stick", {0.4, 0, 0}, {0.4, 0.5, 0})};
    shape.contacts = {hand_made::contact(shape, 0, 1, {0.4, 0.5, 0})};
    return make_structural_graph(std::move(shape), {hand_made::group({0}), hand_made::group({1})});
  };
  const Structural_graph from = graph_of_ring(1), to = graph_of_ring(-1);
  const Correspondence_map map(from, to, pairing({{0, 0}, {1, 1}}));
  for (double t : {0., 0.1, 0.3, 0.6, 0.9}) {
    const auto images = map({0, {t, 0}});
    REQUIRE(images.size() == 1);
    const Point place = evaluate(structure(from).parts[0], {t, 0});
    CHECK((evaluate(structure(to).parts[0], images[0].parameter) - place).norm() < 1e-9);
    const double back = map.inverse()(images[0]).at(0).parameter[0];
    CHECK((evaluate(structure(from).parts[0], {back, 0}) - place).norm() < 1e-9);
  }
}

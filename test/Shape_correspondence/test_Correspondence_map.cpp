// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "box_shapes.h"

#include <CGAL/Shape_correspondence/Correspondence_map.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/build_structural_graph.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <catch2/catch.hpp>

// Maps between shapes of boxes, whose answers are known.

using namespace box_shapes;

namespace {

Structural_graph graph_of(const Segmented_shape& shape)
{
  Structure_options options;
  options.abstraction.abstractor = Bounding_box_abstraction();
  return build_structural_graph(shape, options);
}

Correspondence pairing(std::vector<Part_correspondence> pairs)
{
  Correspondence result;
  result.pairs = std::move(pairs);
  return result;
}

Correspondence identity(const Segmented_shape& shape)
{
  Correspondence result;
  for (std::size_t i = 0; i < shape.parts().size(); ++i)
    result.pairs.push_back({i, i});
  return result;
}

// A box, with a knob on it since a shape has two parts.
Segmented_shape one_box(const Point& size)
{
  Segmented_shape shape;
  shape.add_part("box", box({0, size.y() / 2, 0}, size));
  shape.add_part("knob", box({0, size.y() + 0.02, 0}, {0.04, 0.04, 0.04}));
  return shape;
}

// A plate, and the same divided into three laths side by side along x.
Segmented_shape plate() { return one_box({1.2, 0.1, 0.6}); }
Segmented_shape laths()
{
  Segmented_shape shape("laths");
  for (int i = 0; i < 3; ++i)
    shape.add_part("lath_" + std::to_string(i), box({-0.4 + 0.4 * i, 0.05, 0}, {0.3, 0.1, 0.6}));
  return shape;
}

} // namespace

TEST_CASE("A shape is mapped to itself by the identity")
{
  const Segmented_shape shape = chair();
  const Structural_graph graph = graph_of(shape);
  const Correspondence_map map(graph, graph, identity(shape));
  const Surface_map surfaces(graph, shape, graph, shape, identity(shape));
  for (std::size_t part = 0; part < shape.parts().size(); ++part) {
    for (double u : {0., 0.3, 1.})
      for (double v : {0., 0.8}) {
        const Eigen::Vector2d parameter(u, structure(graph).parts[part].is_sheet() ? v : 0);
        const auto images = map({part, parameter});
        REQUIRE(images.size() == 1);
        CHECK(images[0].part == part);
        CHECK((images[0].parameter - parameter).norm() < 1e-9);
      }
    const Points& points = shape.parts()[part].mesh.points;
    for (Eigen::Index v = 0; v < points.cols(); ++v) {
      REQUIRE(surfaces.source_of(part, v));
      CHECK(surfaces.source_of(part, v)->part == part);
      CHECK((surfaces.source_of(part, v)->point - points.col(v)).norm() < 1e-6);
      CHECK((surfaces.target_of(part, v)->point - points.col(v)).norm() < 1e-6);
    }
  }
}

TEST_CASE("A box is mapped to a box of another size corner to corner, wherever it is")
{
  const Point size(0.9, 0.1, 0.5), other(1.4, 0.2, 0.6);
  const Segmented_shape source = one_box(size), target = moved(one_box(other), {3, 0, {5, 1, -2}}, {0, 1});
  const Surface_map map(graph_of(source), source, graph_of(target), target, pairing({{0, 0}}));
  const Points& points = source.parts()[0].mesh.points;
  for (Eigen::Index v = 0; v < points.cols(); ++v) {
    const Point expected = 3 * points.col(v).cwiseQuotient(size).cwiseProduct(other) + Point(5, 1, -2);
    REQUIRE(map.target_of(0, v));
    CHECK((map.target_of(0, v)->point - expected).norm() < 1e-6);
  }
}

TEST_CASE("A plate that splits into laths is covered by them, each by its third")
{
  const Segmented_shape source = plate(), target = laths();
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
    // Lath and plate lie in the same place: the image is the lath's share of the way
    const Point place = evaluate(structure(from).parts[0], parameter);
    const Point image = evaluate(structure(to).parts[images[0].part], images[0].parameter);
    CHECK(std::abs(place.x() - image.x()) < 0.06);
    CHECK(std::abs(place.z() - image.z()) < 0.02);
    if (part_before == images[0].part) CHECK((image - before).norm() < 2 * 1.2 / n);
    before = image;
    part_before = images[0].part;
    // And back
    bool returns = false;
    for (const Part_parameter& back : map.inverse()(images[0]))
      returns = returns || (back.part == 0 && (back.parameter - parameter).norm() < 1e-9);
    CHECK(returns);
  }
  for (int count : hits)
    CHECK(count == n / 3);
  CHECK(map.inverse()({1, {0.5, 0.5}}).size() == 1);
}

TEST_CASE("A curve that is cut becomes segments, at the border both")
{
  Segmented_shape source = one_box({0.1, 1, 0.1}), target("cut");
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

TEST_CASE("Values are transferred: numbers are interpolated, labels taken from the nearest vertex")
{
  const Segmented_shape source = plate();
  Segmented_shape target = laths();
  target.add_part("extra", box({0, 1, 0}, {0.1, 0.1, 0.1}));
  const Surface_map map(graph_of(source), source, graph_of(target), target, pairing({{0, 0}, {0, 1}, {0, 2}}));
  std::vector<std::vector<double>> z(2);
  std::vector<std::vector<int>> upper(2);
  for (Eigen::Index v = 0; v < source.parts()[0].mesh.points.cols(); ++v) {
    z[0].push_back(source.parts()[0].mesh.points(2, v));
    upper[0].push_back(source.parts()[0].mesh.points(1, v) > 0.07 ? 1 : 0);
  }
  const auto transferred = map.transferred(z, -7.);
  const auto labels = map.transferred(upper, -1);
  for (std::size_t lath = 0; lath < 3; ++lath)
    for (Eigen::Index v = 0; v < target.parts()[lath].mesh.points.cols(); ++v) {
      const Point p = target.parts()[lath].mesh.points.col(v);
      // Where a lath is cut off, all sides of the plate may be as near
      if (std::abs(p.y() - 0.05) > 0.04) CHECK(transferred[lath][std::size_t(v)] == Approx(p.z()).margin(1e-6));
      if (p.y() > 0.09) CHECK(labels[lath][std::size_t(v)] == 1);
    }
  CHECK(transferred[3] == std::vector<double>(transferred[3].size(), -7.));
  CHECK(labels[3] == std::vector<int>(labels[3].size(), -1));
}

TEST_CASE("Places are a property map of the vertices of a CGAL mesh")
{
  const Segmented_shape shape = plate();
  const Structural_graph graph = graph_of(shape);
  const Surface_map map(graph, shape, graph, shape, pairing({{0, 0}}));
  const Source_place_map places(map, 0);
  CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3> mesh;
  for (Eigen::Index v = 0; v < shape.parts()[0].mesh.points.cols(); ++v) {
    const Point p = shape.parts()[0].mesh.points.col(v);
    const auto vertex = mesh.add_vertex({p.x(), p.y(), p.z()});
    CHECK((get(places, vertex)->point - p).norm() < 1e-6);
  }
}

TEST_CASE("A model that is not the graph's is refused")
{
  const Structural_graph graph = graph_of(plate());
  CHECK_THROWS_AS(Surface_map(graph, laths(), graph, plate(), pairing({{0, 0}})), Invalid_input);
}

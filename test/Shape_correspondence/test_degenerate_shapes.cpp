// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Degenerate shapes: each has a graph that matches itself, or is refused with a reason.

#include "box_shapes.h"
#include "model_files.h"

#include <CGAL/Shape_correspondence/build_structural_graph.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <catch2/catch.hpp>

#include <functional>

using namespace CGAL::Shape_correspondence;
using box_shapes::box;
using Catch::Matchers::Contains;

namespace {

Part_mesh triangle(const Point& a, const Point& b, const Point& c)
{
  Part_mesh result{Points(3, 3), Eigen::Matrix3Xi(3, 1)};
  result.points << a, b, c;
  result.triangles << 0, 1, 2;
  return result;
}

Part_mesh moebius_strip()
{
  const int n = 48;
  Part_mesh result{Points(3, 2 * n), Eigen::Matrix3Xi(3, 2 * n)};
  for (int i = 0; i < n; ++i) {
    const double u = 2 * EIGEN_PI * i / n;
    for (int side : {0, 1}) {
      const double r = 1 + (side - 0.5) * 0.5 * std::cos(u / 2);
      result.points.col(2 * i + side) = Point(r * std::cos(u), (side - 0.5) * 0.5 * std::sin(u / 2), r * std::sin(u));
    }
    const bool last = i + 1 == n; // the last pair of triangles closes the strip with its sides exchanged
    const int a = 2 * i, b = 2 * i + 1, c = last ? 1 : 2 * i + 2, d = last ? 0 : 2 * i + 3;
    result.triangles.col(2 * i) << a, b, c;
    result.triangles.col(2 * i + 1) << b, d, c;
  }
  return result;
}

/// Three triangles on one edge of length 1.
Part_mesh fan(const Point& at)
{
  Part_mesh result{Points(3, 5), Eigen::Matrix3Xi(3, 3)};
  result.points << Point(0, 0, 0), Point(1, 0, 0), Point(0.5, -0.7568, -0.6537), Point(0.5, -0.959, 0.2837),
      Point(0.5, -0.2794, 0.9602);
  result.points.colwise() += at;
  result.triangles << 0, 0, 0, 1, 1, 1, 2, 3, 4;
  return result;
}

/// A square whose corners are connected crosswise.
Part_mesh bow_tie(double size)
{
  Part_mesh result{Points(3, 4), Eigen::Matrix3Xi(3, 2)};
  result.points << Point(0, 0, 0), Point(0, 0, size), Point(size, 0, 0), Point(size, 0, size);
  result.triangles << 0, 0, 3, 1, 1, 2;
  return result;
}

Part_mesh points_only()
{
  Part_mesh result{Points(3, 4), Eigen::Matrix3Xi(3, 0)};
  result.points.setRandom();
  return result;
}

Segmented_shape shape_of(const std::vector<Part_mesh>& meshes)
{
  Segmented_shape result;
  for (std::size_t i = 0; i < meshes.size(); ++i)
    result.add_part("part " + std::to_string(i), meshes[i]);
  return result;
}

struct Case
{
  const char* name;
  std::vector<Part_mesh> parts;
  const char* complaint; ///< empty: the shape has a graph, and matches itself
};

std::vector<Case> cases()
{
  const Point o = Point::Zero(), x = Point::UnitX(), y = Point::UnitY(), z = Point::UnitZ(), one = Point::Ones();
  const Part_mesh cube = box(o, one), above = box(y, one);
  return {{"flat parts", {triangle(o, x, z), triangle(o, x, y)}, ""},
          {"all in one plane", {triangle(o, x, z), triangle(x, x + z, z)}, ""},
          {"needles", {triangle(o, x, x / 2 + 1e-5 * y), triangle(o, y, y / 2 + 1e-5 * z)}, ""},
          {"a sliver of no area", {cube, triangle(o, x, x / 2 + 1e-17 * y)}, "zero area"},
          {"parts at the same place", {cube, cube}, ""},
          {"a part inside a part", {box(o, 3 * one), cube}, ""},
          {"no contacts", {cube, box(100 * x, one), box(70 * z, one)}, ""},
          {"1e-12 long", {box(o, 1e-12 * one), box(1e-12 * y, 1e-12 * one)}, ""},
          {"1e12 long", {box(o, 1e12 * one), box(1e12 * y, 1e12 * one)}, ""},
          {"1e12 away", {box(1e12 * one, one), box(1e12 * one + y, one)}, ""},
          {"small beside large", {box(o, 1e6 * one), box(5e5 * y, 1e-3 * one)}, ""},
          {"1e7 away, and tiny", {fan(Point(0, -1e7, 1e7)), bow_tie(1.7e-6)}, ""},
          {"1e9 away, and tiny", {fan(Point(0, -1e9, 1e9)), bow_tie(1.7e-6)}, ""},
          {"1e12 away, and tiny", {fan(Point(0, -1e12, 1e12)), bow_tie(1.7e-6)}, ""},
          {"a Moebius strip", {moebius_strip(), above}, ""},
          {"points only", {cube, points_only()}, "no triangles"},
          {"one part", {cube}, "only one part"},
          {"beyond 1e15", {cube, box(2e15 * x, one)}, "beyond 1e15"}};
}

} // namespace

TEST_CASE("Degenerate shapes are graphs that match themselves, or errors that say why")
{
  for (const Case& c : cases()) {
    INFO(c.name);
    const std::string message = model_files::complaint([&] {
      const Structural_graph graph = build_structural_graph(shape_of(c.parts));
      CHECK(is_valid_structural_graph(graph, true));
      const Correspondence found = find_correspondence(graph, graph);
      CHECK(found.pairs.size() >= c.parts.size());
      CHECK(std::isfinite(found.energy));
    });
    if (*c.complaint)
      CHECK_THAT(message, Contains(c.complaint));
    else
      CHECK(message == "");
  }
}

TEST_CASE("A thousand identical parts are rows, and are matched where each is a group of its own")
{
  Segmented_shape shape;
  for (int i = 0; i < 1000; ++i)
    shape.add_part("part " + std::to_string(i), box(Point(i % 10, i / 10 % 10, i / 100), Point::Ones()));
  Structure_options options;
  options.abstraction.abstractor = Bounding_box_abstraction();
  CHECK(num_vertices(build_structural_graph(shape, options)) == 100);
  options.symmetry.enabled = false;
  const Structural_graph graph = build_structural_graph(shape, options);
  CHECK(num_vertices(graph) == 1000);
  CHECK(find_correspondence(graph, graph).pairs.size() >= 1000);
  for (const Search_method method : {Search_method::BEAM, Search_method::EXACT}) {
    Search_options search;
    search.method = method;
    const Correspondence found = find_correspondence(graph, graph, search);
    CHECK(found.groups.size() == 1000);
    REQUIRE(!found.warnings.empty());
    CHECK_THAT(found.warnings.front(), Contains("parts were matched by their costs in its place"));
    search.maximum_parts = 4;
    CHECK(find_correspondence(graph, graph, search).groups.size() == 4);
  }
  // Boxes of different sizes in a row
  Segmented_shape row;
  for (int i = 0; i < 160; ++i)
    row.add_part("part " + std::to_string(i), box(Point(2 * i, 0, 0), Point(2, 1 + i % 13, 1 + i % 7)));
  const Structural_graph boxes = build_structural_graph(row, options);
  Search_options beam;
  beam.method = Search_method::BEAM;
  const Correspondence found = find_correspondence(boxes, boxes, beam);
  CHECK(found.groups.size() == 160);
  REQUIRE(!found.warnings.empty());
  CHECK_THAT(found.warnings.front(), Contains("50 largest parts were matched first"));
  for (int i = 0; i <= 1000; ++i)
    shape.add_part("more " + std::to_string(i), box(Point(0, -1, 0), Point::Ones()));
  CHECK_THAT(model_files::complaint([&] { build_structural_graph(shape, options); }),
             Contains("2001 parts") && Contains("at most 2000") && Contains("join"));
}

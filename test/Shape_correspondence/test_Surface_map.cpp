// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "box_shapes.h"
#include "boxed_graphs.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/Surface_map.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <catch2/catch.hpp>

// Maps between surfaces of shapes made of boxes, whose results are known.

using namespace box_shapes;
using namespace boxed_graphs;

TEST_CASE("The surface of a shape is mapped to itself by the identity")
{
  const Segmented_shape shape = chair();
  const Structural_graph graph = graph_of(shape);
  const Surface_map surfaces(graph, shape, graph, shape, identity(shape));
  for (std::size_t part = 0; part < shape.parts().size(); ++part) {
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
  const Segmented_shape source = knobbed_box(size), target = moved(knobbed_box(other), {3, 0, {5, 1, -2}}, {0, 1});
  const Surface_map map(graph_of(source), source, graph_of(target), target, pairing({{0, 0}}));
  const Points& points = source.parts()[0].mesh.points;
  for (Eigen::Index v = 0; v < points.cols(); ++v) {
    const Point expected = 3 * points.col(v).cwiseQuotient(size).cwiseProduct(other) + Point(5, 1, -2);
    REQUIRE(map.target_of(0, v));
    CHECK((map.target_of(0, v)->point - expected).norm() < 1e-6);
  }
}

TEST_CASE("Values are transferred: numbers are interpolated, labels taken from the nearest vertex")
{
  const Segmented_shape source = knobbed_plate();
  Segmented_shape target = three_laths();
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
      // Only vertices of the upper and lower faces: to others, several sides of the plate may be equally near
      if (std::abs(p.y() - 0.05) > 0.04) CHECK(transferred[lath][std::size_t(v)] == Approx(p.z()).margin(1e-6));
      if (p.y() > 0.09) CHECK(labels[lath][std::size_t(v)] == 1);
    }
  CHECK(transferred[3] == std::vector<double>(transferred[3].size(), -7.));
  CHECK(labels[3] == std::vector<int>(labels[3].size(), -1));
}

TEST_CASE("A model that does not belong to its graph is refused")
{
  const Structural_graph graph = graph_of(knobbed_plate());
  CHECK_THROWS_AS(Surface_map(graph, three_laths(), graph, knobbed_plate(), pairing({{0, 0}})), Invalid_input);
}

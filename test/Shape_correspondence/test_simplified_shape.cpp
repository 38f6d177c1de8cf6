// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "box_shapes.h"
#include "io/write/pictures.h"

#include <catch2/catch.hpp>

using namespace CGAL::Shape_correspondence;
using box_shapes::box;

namespace {

Eigen::AlignedBox3d bounds(const Part_mesh& mesh)
{
  return {mesh.points.rowwise().minCoeff(), mesh.points.rowwise().maxCoeff()};
}

} // namespace

TEST_CASE("A shape of few triangles stays as it is")
{
  const Segmented_shape table = box_shapes::table();
  const std::size_t all = IO::number_of_triangles(table);
  CHECK(all == 5 * 48);
  const Segmented_shape same = IO::simplified_shape(table, all);
  for (std::size_t i = 0; i < 5; ++i)
    CHECK(same.parts()[i].mesh.points == table.parts()[i].mesh.points);
}

TEST_CASE("A shape is simplified to a given number of triangles, and keeps its parts, their names and their extents")
{
  Segmented_shape shape("boxes", Point::UnitZ());
  shape.add_part("large", box({0, 0, 0}, {1, 2, 3}, 0.3, 30)); // 10800 triangles
  shape.add_part("thin", box({5, 0, 0}, {0.01, 0.01, 2}, 0, 30));
  shape.add_part("plain", box({9, 0, 0}, {1, 1, 1}, 0, 1)); // 12 triangles
  const Segmented_shape simple = IO::simplified_shape(shape, 1000);
  CHECK(IO::number_of_triangles(simple) <= 1050);
  CHECK(IO::number_of_triangles(simple) > 500);
  CHECK(simple.name() == "boxes");
  CHECK(simple.up() == Point::UnitZ());
  REQUIRE(simple.parts().size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    INFO(i);
    CHECK(simple.parts()[i].name == shape.parts()[i].name);
    const Eigen::AlignedBox3d before = bounds(shape.parts()[i].mesh), after = bounds(simple.parts()[i].mesh);
    CHECK((before.min() - after.min()).norm() < 0.01 * before.diagonal().norm());
    CHECK((before.max() - after.max()).norm() < 0.01 * before.diagonal().norm());
  }
  CHECK(simple.parts()[2].mesh.triangles.cols() == 12);
}

TEST_CASE("Triangles that form no manifold are simplified, too")
{
  Segmented_shape shape("fan");
  Part_mesh fan; // triangles that share one edge
  const int n = 200;
  fan.points.resize(3, n + 2);
  fan.triangles.resize(3, n);
  fan.points.col(0) = Point::Zero(), fan.points.col(1) = Point::UnitY();
  for (int i = 0; i < n; ++i) {
    fan.points.col(i + 2) = Point(std::cos(0.03 * i), 0.5, std::sin(0.03 * i));
    fan.triangles.col(i) << 0, 1, i + 2;
  }
  shape.add_part("fan", fan);
  const Segmented_shape simple = IO::simplified_shape(shape, 50);
  CHECK(simple.parts()[0].mesh.triangles.cols() > 0);
  CHECK(simple.parts()[0].mesh.points.allFinite());
}

TEST_CASE("No vertex of a simplified part leaves the extents of the part")
{
  const auto card = [](int k) {
    return box({std::sin(3.1 * k), std::sin(1.7 * k), std::sin(2.3 * k)}, {1, 0.5, 0.001}, 0.1 * k, 1);
  };
  const int n = 100;
  const Eigen::Index points = card(0).points.cols(), triangles = card(0).triangles.cols();
  Part_mesh cards; // nearly flat, so that the planes of their triangles meet far away
  cards.points.resize(3, points * n);
  cards.triangles.resize(3, triangles * n);
  for (int k = 0; k < n; ++k) {
    cards.points.middleCols(points * k, points) = card(k).points;
    cards.triangles.middleCols(triangles * k, triangles) = card(k).triangles.array() + int(points) * k;
  }
  Segmented_shape shape("cards");
  shape.add_part("cards", cards);
  const Part_mesh simple = IO::simplified_shape(shape, 400).parts()[0].mesh;
  CHECK(simple.triangles.cols() <= 600);
  const Eigen::AlignedBox3d before = bounds(cards), after = bounds(simple);
  CHECK((before.min() - after.min()).maxCoeff() < 0.001 * before.diagonal().norm());
  CHECK((after.max() - before.max()).maxCoeff() < 0.001 * before.diagonal().norm());
}

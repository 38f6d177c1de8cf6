// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "part_meshes.h"

#include <CGAL/Shape_correspondence/segment_mesh.h>

#include <CGAL/Timer.h>

#include <catch2/catch.hpp>

#include <cmath>

using namespace CGAL::Shape_correspondence;

namespace {

/// A dumb-bell: a surface of revolution, thick at both ends.
Part_mesh dumb_bell()
{
  const int rings = 60, sides = 24;
  Part_mesh mesh;
  mesh.points.resize(3, rings * sides + 2);
  for (int i = 0; i < rings; ++i) {
    const double x = -1 + 2. * i / (rings - 1);
    const double r = std::abs(x) > 0.5 ? 0.5 : 0.1;
    for (int j = 0; j < sides; ++j) {
      const double angle = 2 * EIGEN_PI * j / sides;
      mesh.points.col(i * sides + j) << 2 * x, r * std::cos(angle), r * std::sin(angle);
    }
  }
  mesh.points.col(rings * sides) << -2, 0, 0;
  mesh.points.col(rings * sides + 1) << 2, 0, 0;
  mesh.triangles.resize(3, 2 * rings * sides);
  Eigen::Index t = 0;
  for (int j = 0; j < sides; ++j) {
    const int k = (j + 1) % sides, last = (rings - 1) * sides;
    for (int i = 0; i + 1 < rings; ++i) {
      mesh.triangles.col(t++) << i * sides + j, (i + 1) * sides + k, i * sides + k;
      mesh.triangles.col(t++) << i * sides + j, (i + 1) * sides + j, (i + 1) * sides + k;
    }
    mesh.triangles.col(t++) << rings * sides, j, k;
    mesh.triangles.col(t++) << rings * sides + 1, last + k, last + j;
  }
  return mesh;
}

Part_mesh twice(const Part_mesh& mesh)
{
  Part_mesh result;
  result.points.resize(3, 2 * mesh.points.cols());
  result.points << mesh.points, mesh.points.colwise() + Point(0, 3, 0);
  result.triangles.resize(3, 2 * mesh.triangles.cols());
  result.triangles << mesh.triangles, (mesh.triangles.array() + int(mesh.points.cols())).matrix();
  return result;
}

} // namespace

TEST_CASE("Thick and thin pieces of a mesh become parts")
{
  const Segmented_shape shape = segment_mesh(dumb_bell(), {}, "bell", Point::UnitZ()).shape;
  CHECK(shape.name() == "bell");
  CHECK(shape.up() == Point::UnitZ());
  REQUIRE(shape.parts().size() == 3);
  Eigen::Index triangles = 0;
  for (const Shape_part& part : shape.parts()) {
    CHECK(part.name.rfind("segment_", 0) == 0);
    triangles += part.mesh.triangles.cols();
  }
  CHECK(triangles == dumb_bell().triangles.cols());

  SECTION("the same in every run")
  {
    const Segmented_shape again = segment_mesh(dumb_bell()).shape;
    for (std::size_t i = 0; i < 3; ++i)
      CHECK(again.parts()[i].mesh.points == shape.parts()[i].mesh.points);
  }
}

TEST_CASE("Connected components are parts, open ones as they are")
{
  CHECK(segment_mesh(twice(dumb_bell())).shape.parts().size() == 6);
  Part_mesh open = twice(dumb_bell());
  open.triangles = open.triangles.leftCols(open.triangles.cols() - 5).eval();
  CHECK(segment_mesh(open).shape.parts().size() == 4);
}

TEST_CASE("Components without area are left out, and counted")
{
  Part_mesh mesh = dumb_bell();
  const Eigen::Index n = mesh.points.cols();
  mesh.points.conservativeResize(3, n + 3);
  mesh.points.rightCols(3) << 5, 6, 7, 0, 0, 0, 0, 0, 0;
  mesh.triangles.conservativeResize(3, mesh.triangles.cols() + 1);
  mesh.triangles.rightCols(1) << int(n), int(n + 1), int(n + 2);
  const Mesh_segmentation whole = segment_mesh(dumb_bell()), segmentation = segment_mesh(mesh);
  CHECK(segmentation.shape.parts().size() == whole.shape.parts().size());
  CHECK(segmentation.pieces_left_out == 1);
  CHECK(whole.pieces_left_out == 0);
}

TEST_CASE("A closed surface without an inside, where the thickness cannot be measured, stays one part")
{
  Part_mesh both_sides;
  both_sides.points.resize(3, 4);
  both_sides.points << 0.5, 0.58, 0.5, 0.58, 0, 0, 1, 1, 200, 200, 200, 200;
  both_sides.triangles.resize(3, 4);
  both_sides.triangles << 0, 0, 1, 1, 1, 3, 0, 2, 3, 2, 2, 3;
  const Mesh_segmentation segmentation = segment_mesh(both_sides);
  CHECK(segmentation.shape.parts().size() == 1);
  CHECK(segmentation.pieces_kept_whole == 1);
  CHECK(segment_mesh(dumb_bell()).pieces_kept_whole == 0);
}

TEST_CASE("A closed surface of needles, each of whose rays would meet most of them, stays one part")
{
  CGAL::Timer timer;
  timer.start();
  const Mesh_segmentation segmentation = segment_mesh(part_meshes::bipyramid(8000));
  CHECK(segmentation.shape.parts().size() == 1);
  CHECK(segmentation.pieces_kept_whole == 1);
  CHECK(timer.time() < 20); // of processor time; measuring its thickness took minutes
  CHECK(segment_mesh(part_meshes::bipyramid(500)).pieces_kept_whole == 0);
}

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/segment_mesh.h>

#include <Eigen/Geometry>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <utility>
#include <vector>

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

/// The boundary of a solid made of unit cubes within a grid of 12 × 12 × 12.
Part_mesh surface_of_cubes(const std::function<bool(int, int, int)>& in_solid)
{
  constexpr int n = 12;
  using Corner = std::array<int, 3>;
  const auto is_in = [&](const Corner& c) {
    return std::all_of(c.begin(), c.end(), [](int x) { return x >= 0 && x < n; }) && in_solid(c[0], c[1], c[2]);
  };
  std::map<Corner, int> numbers;
  std::vector<std::array<int, 3>> triangles;
  const auto number = [&](const Corner& c) { return numbers.try_emplace(c, int(numbers.size())).first->second; };
  for (int cube = 0; cube < n * n * n; ++cube)
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (int side : {0, 1}) {
        const Corner c{cube / (n * n), cube / n % n, cube % n};
        Corner beyond = c;
        beyond[axis] += 2 * side - 1;
        if (!is_in(c) || is_in(beyond)) continue;
        std::array<int, 4> corners;
        for (std::size_t k = 0; k < 4; ++k) {
          Corner corner = c;
          corner[axis] += side;
          corner[(axis + 1) % 3] += int(k == 1 || k == 2);
          corner[(axis + 2) % 3] += int(k >= 2);
          corners[k] = number(corner);
        }
        if (side == 0) std::swap(corners[1], corners[3]);
        triangles.push_back({corners[0], corners[1], corners[2]});
        triangles.push_back({corners[0], corners[2], corners[3]});
      }
  Part_mesh mesh;
  mesh.points.resize(3, Eigen::Index(numbers.size()));
  for (const auto& [corner, point] : numbers)
    mesh.points.col(point) << corner[0], corner[1], corner[2];
  mesh.triangles.resize(3, Eigen::Index(triangles.size()));
  for (std::size_t t = 0; t < triangles.size(); ++t)
    mesh.triangles.col(Eigen::Index(t)) << triangles[t][0], triangles[t][1], triangles[t][2];
  return mesh;
}

} // namespace

TEST_CASE("A surface is divided where it is concave, also if it is everywhere equally thick")
{
  const Part_mesh table = surface_of_cubes(
      [](int x, int y, int z) { return y == 10 || (y < 10 && (x == 0 || x == 11) && (z == 0 || z == 11)); });
  const Part_mesh block = surface_of_cubes([](int, int, int) { return true; });
  CHECK(segment_mesh(table).shape.parts().size() == 5);
  CHECK(segment_mesh(block).shape.parts().size() == 1);

  SECTION("at any size, and after a turn about the up axis")
  {
    Part_mesh turned = table;
    turned.points = Eigen::AngleAxisd(1, Point::UnitY()).toRotationMatrix() * (1000 * table.points);
    CHECK(segment_mesh(turned).shape.parts().size() == 5);
  }

  SECTION("options")
  {
    Segmentation_options options;
    options.least_area = 0.2; // share of the surface; each leg has less
    CHECK(segment_mesh(table, options).shape.parts().size() == 1);
    options = {};
    options.patches = 1;
    CHECK(segment_mesh(table, options).shape.parts().size() == 1);
    options.patches = 0;
    CHECK_THROWS_AS(segment_mesh(table, options), Invalid_input);
  }
}

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

TEST_CASE("Options of a segmentation that are out of their ranges are refused")
{
  for (const double wrong : {-0.1, 1.1, std::nan("")}) {
    Segmentation_options options;
    options.probability = wrong;
    CHECK_THROWS_AS(segment_mesh(dumb_bell(), options), Invalid_input);
    options = {};
    options.least_area = wrong;
    CHECK_THROWS_AS(segment_mesh(dumb_bell(), options), Invalid_input);
  }
}

TEST_CASE("Connected components are segmented separately, and open ones stay whole")
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

TEST_CASE("A closed surface without an inside stays one part")
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

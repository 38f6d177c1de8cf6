// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "abstraction/recognize_prism.h"
#include "part_meshes.h"

#include <catch2/catch.hpp>

#include <cmath>

// Prisms recognized by their faces: their axes and middle layers are exact.

using namespace part_meshes;

namespace {

constexpr double rounding = 1e-9;

std::optional<std::variant<Curve, Sheet>> recognized(const Part_mesh& mesh, double volume)
{
  return internal::recognize_prism(mesh, volume, 5, 4);
}

/// Half the length of a straight curve through the origin in a given direction; -1 for other curves and for sheets.
double half_length(const std::optional<std::variant<Curve, Sheet>>& found, const Point& direction)
{
  if (!found || !std::holds_alternative<Curve>(*found)) {
    return -1;
  }
  const Points& points = std::get<Curve>(*found).points;
  const Eigen::RowVectorXd along = direction.transpose() * points;
  const bool is_on_line = (points - direction * along).norm() < rounding;
  const bool is_centred = std::abs(along.maxCoeff() + along.minCoeff()) < rounding;
  return points.cols() == 5 && is_on_line && is_centred ? along.maxCoeff() : -1;
}

Part_mesh turned_copy(Part_mesh mesh, const Eigen::Matrix3d& rotation)
{
  mesh.points = rotation * mesh.points;
  return mesh;
}

Part_mesh cylinder(double radius, double height, int n)
{
  return turned({{0, -height / 2}, {radius, -height / 2}, {radius, height / 2}, {0, height / 2}}, n);
}

double volume_of_cylinder(double radius, double height, int n)
{
  return height * radius * radius * 0.5 * n * std::sin(2 * EIGEN_PI / n);
}

const Eigen::Matrix3d tilt = Eigen::AngleAxisd(0.7, Point(1, 2, 3).normalized()).toRotationMatrix();

} // namespace

TEST_CASE("A long box becomes the line through its middle, however it lies")
{
  const Part_mesh leg = box({-0.5, -5, -0.4}, {0.5, 5, 0.4}), strip = box({-0.3, -5, -0.01}, {0.3, 5, 0.01});
  CHECK(half_length(recognized(leg, 8), Point::UnitY()) == Approx(5));
  CHECK(half_length(recognized(turned_copy(leg, tilt), 8), tilt.col(1)) == Approx(5));
  CHECK(half_length(recognized(strip, 0.12), Point::UnitY()) == Approx(5));
}

TEST_CASE("A long cylinder becomes its axis, of however many sides")
{
  for (int n : {5, 6, 12, 31}) {
    const Part_mesh rod = cylinder(0.5, 8, n);
    CHECK(half_length(recognized(rod, volume_of_cylinder(0.5, 8, n)), Point::UnitY()) == Approx(4));
  }
}

TEST_CASE("The axis of a long prism goes through the centroid of its profile")
{
  // A right-angled triangle with its centroid at the origin.
  Part_mesh wedge;
  wedge.points.resize(3, 6);
  wedge.points << -1. / 3, 2. / 3, -1. / 3, -1. / 3, 2. / 3, -1. / 3, //
      -4, -4, -4, 4, 4, 4,                                            //
      -1. / 3, -1. / 3, 2. / 3, -1. / 3, -1. / 3, 2. / 3;
  wedge.triangles.resize(3, 8);
  wedge.triangles << 0, 3, 0, 0, 1, 1, 2, 2, //
      1, 5, 3, 4, 4, 5, 5, 3,                //
      2, 4, 4, 1, 5, 2, 3, 0;
  CHECK(half_length(recognized(wedge, 4), Point::UnitY()) == Approx(4));
}

TEST_CASE("A plate becomes its middle layer, up to its rim")
{
  const Point half(2, 0.1, 1.5);
  for (const Eigen::Matrix3d& rotation : {Eigen::Matrix3d(Eigen::Matrix3d::Identity()), tilt}) {
    const auto found = recognized(turned_copy(box(-half, half), rotation), 2.4);
    REQUIRE(found);
    const Sheet& sheet = std::get<Sheet>(*found);
    REQUIRE(sheet.points.cols() == 16);
    const Points in_box = rotation.transpose() * sheet.points;
    CHECK(in_box.row(1).norm() < rounding);
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) {
        const Eigen::Vector2d wanted(2 * (2 * i / 3. - 1), 1.5 * (2 * j / 3. - 1));
        double nearest = 1;
        for (const auto& p : in_box.colwise()) {
          nearest = std::min(nearest, (Eigen::Vector2d(p.x(), p.z()) - wanted).norm());
        }
        CHECK(nearest < rounding);
      }
    }
  }
}

TEST_CASE("A disc becomes its middle layer")
{
  const auto found = recognized(cylinder(1, 0.2, 32), volume_of_cylinder(1, 0.2, 32));
  REQUIRE(found);
  const Points& points = std::get<Sheet>(*found).points;
  CHECK(points.row(1).norm() < rounding);
  CHECK(points.colwise().norm().maxCoeff() == Approx(1).epsilon(0.01));
}

TEST_CASE("Prisms neither clearly long nor clearly flat are left to the medial axis")
{
  CHECK_FALSE(recognized(box({-1, -1, -1}, {1, 1, 1}), 8));
  CHECK_FALSE(recognized(box({-1, -3, -1}, {1, 3, 1}), 24));
  CHECK_FALSE(recognized(box({-1, -5, -0.15}, {1, 5, 0.15}), 6)); // between a strip and a blade
}

TEST_CASE("Parts that are no prisms are left to the medial axis")
{
  // A leg that tapers to four fifths of its width, a tube, a box that lacks a twentieth of its volume, a flat box
  const Part_mesh tapered = turned({{0, -5}, {0.5, -5}, {0.4, 5}, {0, 5}}, 16);
  const double frustum = 10. / 3 * (0.25 + 0.2 + 0.16) * 8 * std::sin(EIGEN_PI / 8);
  CHECK_FALSE(recognized(tapered, frustum));
  CHECK_FALSE(recognized(cylinder(0.5, 8, 12), 0.5 * volume_of_cylinder(0.5, 8, 12)));
  CHECK_FALSE(recognized(box({-0.5, -5, -0.4}, {0.5, 5, 0.4}), 0.95 * 8));
  CHECK_FALSE(recognized(box({-0.5, -5, 0}, {0.5, 5, 0}), 0));
}

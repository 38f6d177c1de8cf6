// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "abstraction/fit_sheet.h"
#include "base/directions.h"
#include "base/planar_hull.h"

#include <catch2/catch.hpp>

#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

using namespace CGAL::Shape_correspondence;
using namespace CGAL::Shape_correspondence::internal;

namespace {

/// A regular polygon with one corner at a given angle, with noise of the size of rounding errors.
Planar_points polygon(int corners, double angle, unsigned seed)
{
  std::mt19937 random(seed);
  const auto noise = [&] { return 1e-13 * (double(random() % 1000) - 500) / 500; };
  Planar_points result;
  for (int k = 0; k < corners; ++k) {
    const double at = angle + 2 * EIGEN_PI * k / corners;
    result.emplace_back(std::cos(at) + noise(), std::sin(at) + noise());
  }
  return result;
}

double degrees(const Eigen::Vector2d& direction) { return std::atan2(direction.y(), direction.x()) * 180 / EIGEN_PI; }

Points ring(double width, unsigned seed)
{
  const Planar_points round = polygon(20, 0.3, seed);
  Points result(3, Eigen::Index(round.size()));
  for (std::size_t k = 0; k < round.size(); ++k)
    result.col(Eigen::Index(k)) << width * round[k].x(), round[k].y(), 1e-13 * double(seed);
  return result;
}

} // namespace

TEST_CASE("Of equally small bounding rectangles the least rotated is taken, to the left if two are, despite rounding")
{
  struct
  {
    int corners;
    double angle, expected;
  } const cases[] = {
      {4, 45, 0},   // parallel to the axes
      {4, 0, 45},   // stands on a corner
      {4, 65, 20},  // rotated slightly
      {4, 15, -30}, // rotated by 60°, which is the same as -30°
      {20, 9, 0},   // two of its edges are parallel to the axes
      {20, 0, 9},   // its edges are rotated by 9° and -9°
      {20, 2, -7},  // rotated by -7° and 11°
      {36, 5, 0},   //
      {36, 0, 5},   //
  };
  for (const auto& c : cases)
    for (unsigned seed = 0; seed < 50; ++seed) {
      CAPTURE(c.corners, c.angle, seed);
      const Planar_points hull = planar_hull(polygon(c.corners, c.angle * EIGEN_PI / 180, seed));
      CHECK(degrees(least_rectangle_direction(hull)) == Approx(c.expected).margin(1e-6));
    }
}

TEST_CASE("Of a rectangle the side along x is taken, wherever its outline begins")
{
  for (unsigned seed = 0; seed < 20; ++seed) {
    Planar_points corners = polygon(4, EIGEN_PI / 4, seed);
    for (auto& p : corners)
      p.x() *= 3;
    CHECK(degrees(least_rectangle_direction(planar_hull(corners))) == Approx(0).margin(1e-6));
  }
}

TEST_CASE("Axes of points on a circle do not depend on rounding; other points have their principal axes")
{
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Eigen::Matrix3d round = principal_plane(ring(1, seed)).axes, longer = principal_plane(ring(1.1, seed)).axes;
    CHECK(round.col(0).isApprox(Point::UnitY(), 1e-6));
    CHECK(round.col(2).isApprox(Point::UnitZ(), 1e-6));
    CHECK(round.col(0).cross(round.col(1)).isApprox(round.col(2), 1e-6));
    CHECK(longer.col(0).x() == Approx(1).margin(0.02));
  }
}

TEST_CASE("A direction's normal does not depend on its last digits")
{
  const double tiny = 1e-15;
  for (const Point& axis : {Point(Point::UnitX()), Point(Point::UnitY()), Point(Point::UnitZ())})
    for (const Point& noise : {Point(tiny, -tiny, tiny), Point(-tiny, tiny, tiny), Point(tiny, tiny, -tiny)}) {
      const Point normal = some_normal(axis), other = some_normal((axis + noise).normalized());
      CHECK(normal.isApprox(other, 1e-12));
      CHECK(std::abs(normal.dot(axis)) < 1e-15);
      CHECK(normal.norm() == Approx(1));
    }
}

TEST_CASE("A direction's sign does not depend on its last digits")
{
  const double tiny = 1e-15;
  const Point x = Point::UnitX(), y = Point::UnitY(), z = Point::UnitZ(), noise(tiny, -tiny, tiny);
  for (const Point& axis : {x, y, z})
    for (const Point& seen : {Point(axis + noise), Point(axis - noise), Point(-axis + noise), Point(-axis - noise)})
      CHECK(with_fixed_sign(seen).isApprox(axis, 1e-12));
  CHECK(with_fixed_sign(Point(0, -0.6, 0.8)) == Point(0, 0.6, -0.8));
}

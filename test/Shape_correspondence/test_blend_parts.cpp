// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/directions.h"
#include "blend/Blend_stage.h"
#include "blend_checks.h"
#include "box_models.h"
#include "box_shapes.h"
#include "map/Piece_pair.h"

#include <catch2/catch.hpp>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

// Components of blends: pieces of parts, gaps between components, locations on surfaces.

using namespace CGAL::Shape_correspondence;
using namespace blend_checks;

namespace {

using Surface_tree = internal::contacts::Triangle_tree;

/// A torus about the z axis with radius 1.
Part_mesh ring(double thickness, const Point& middle = Point::Zero())
{
  constexpr int around = 24, across = 10;
  Part_mesh result{Points(3, around * across), Eigen::Matrix3Xi(3, 2 * around * across)};
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      const double u = 2 * EIGEN_PI * i / around, v = 2 * EIGEN_PI * j / across, r = 1 + thickness * std::cos(v);
      result.points.col(i * across + j) = middle + Point(r * std::cos(u), r * std::sin(u), thickness * std::sin(v));
      const int a = i * across + j, b = i * across + (j + 1) % across;
      const int c = (i + 1) % around * across + j, d = (i + 1) % around * across + (j + 1) % across;
      result.triangles.col(2 * a) << a, c, d;
      result.triangles.col(2 * a + 1) << a, d, b;
    }
  return result;
}

double volume(const Part_mesh& mesh)
{
  double sum = 0;
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
    const auto corner = [&](int i) -> Point { return mesh.points.col(mesh.triangles(i, t)); };
    sum += corner(0).dot(corner(1).cross(corner(2))) / 6;
  }
  return sum;
}

} // namespace

TEST_CASE("Pieces of a part are closed, within it, and make up its volume, also where its surface crosses itself")
{
  Part_mesh part = ring(0.2);
  if (GENERATE(false, true)) { // two linked rings
    const Part_mesh other = ring(0.2, Point(0.1, 0.05, 0));
    Part_mesh both{Points(3, 2 * part.points.cols()), Eigen::Matrix3Xi(3, 2 * part.triangles.cols())};
    both.points << part.points, other.points;
    both.triangles << part.triangles, other.triangles.array() + int(part.points.cols());
    part = both;
  }
  const internal::Part_chart chart = internal::Part_chart::box(part.points, Eigen::Matrix3d::Identity());
  const double at = GENERATE(0.3, 0.75, 0.9);
  const int axis = GENERATE(0, 2); // the cut goes across the ring, or along all of it
  internal::Chart_box low = internal::whole_chart(), high = low;
  low.max()[axis] = high.min()[axis] = at;
  double sum = 0;
  for (const internal::Chart_box& box : {low, high}) {
    const Part_mesh piece = internal::piece_of(part, chart, box);
    CHECK(is_closed(piece));
    sum += volume(piece);
    internal::Chart_box reach;
    for (Eigen::Index i = 0; i < piece.points.cols(); ++i)
      reach.extend(chart.coordinates(piece.points.col(i)));
    CHECK(box.min()[axis] - 1e-6 < reach.min()[axis]);
    CHECK(reach.max()[axis] < box.max()[axis] + 1e-6);
  }
  CHECK(sum == Approx(volume(part)));
  CHECK(volume(part) > 0);
}

TEST_CASE("Pieces of a bent part are within it")
{
  // Half of a hoop, divided lengthwise
  Part_mesh hoop = box_shapes::box({0, 0, 0}, {1, 0.1, 0.06}, 0, 24);
  Points spine(3, 33);
  for (Eigen::Index i = 0; i < spine.cols(); ++i)
    spine.col(i) << double(i) / double(spine.cols() - 1) - 0.5, 0, 0;
  const auto bend = [](Points& points) {
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
      const double angle = EIGEN_PI * points(0, i), radius = 0.4 + points(1, i);
      points.col(i).head<2>() << radius * std::sin(angle), radius * std::cos(angle);
    }
  };
  bend(hoop.points);
  bend(spine);
  Part_abstraction part;
  part.geometry = Curve{spine, false};
  const internal::Part_chart chart = internal::Part_chart::around(part, spine, hoop.points);
  const Surface_tree surface = internal::tree_of(hoop.points, hoop.triangles);
  for (int axis : {1, 2}) {
    internal::Chart_box half = internal::whole_chart();
    half.max()[axis] = 0;
    const Part_mesh piece = internal::piece_of(hoop, chart, half);
    double farthest = 0;
    for (Eigen::Index t = 0; t < piece.triangles.cols(); ++t) {
      const auto corner = [&](int i) -> Point { return piece.points.col(piece.triangles(i, t)); };
      const Point p = (corner(0) + corner(1) + corner(2)) / 3;
      std::size_t triangle = 0;
      if (!is_inside(p, hoop)) farthest = std::max(farthest, (surface.nearest(p, triangle) - p).norm());
    }
    CHECK(farthest < 0.002);
  }
}

TEST_CASE("The piece of a part in a box that contains none of it is closed and tiny")
{
  const Part_mesh part = ring(0.2);
  const internal::Part_chart chart = internal::Part_chart::box(part.points, Eigen::Matrix3d::Identity());
  const internal::Chart_box hole(Point(-0.4, -0.4, -1), Point(0.4, 0.4, 1));
  const Part_mesh piece = internal::piece_of(part, chart, hole);
  CHECK(is_closed(piece));
  CHECK(volume(piece) > 0);
  CHECK((piece.points.rowwise().maxCoeff() - piece.points.rowwise().minCoeff()).maxCoeff() < 0.01);
  CHECK(std::abs(piece.points.row(2).maxCoeff()) < 0.2 + 1e-6);
}

TEST_CASE("The widest gap between surfaces is the longest edge of their minimum spanning tree")
{
  // Four rows of boxes, with gaps of 0.12 in each row, and of 0.11, 0.13 and 0.15 between them
  std::vector<Surface_tree> surfaces;
  for (int row = 0; row < 4; ++row)
    for (int i = 0; i < 3; ++i) {
      const Part_mesh box = box_shapes::box({1.12 * i, 1.1 * row + 0.01 * row * row, 0}, {1, 1, 1});
      surfaces.push_back(internal::tree_of(box.points, box.triangles));
    }
  CHECK(internal::widest_gap(internal::pointers_to(surfaces)) == Approx(0.15));
  CHECK(internal::widest_gap(internal::pointers_to(surfaces), 0.14) == Approx(0.15));
  CHECK(internal::widest_gap(internal::pointers_to(surfaces), 0.16) == 0.16);
  CHECK(internal::widest_gap({&surfaces[0]}) == 0);
}

TEST_CASE("Approximate distances exceed exact ones by at most a ninth of their excess over the sufficient distance")
{
  // Oblique sheets, whose bounding boxes are poor bounds
  const auto sheet = [](double height) {
    Part_mesh mesh = box_shapes::box({0, 0, 0}, {1, 1, 0}, 0, 12);
    for (Eigen::Index i = 0; i < mesh.points.cols(); ++i) {
      const Point p = mesh.points.col(i);
      mesh.points(2, i) += p.x() + 0.7 * p.y() + 0.1 * std::sin(height * 7 + 9 * p.x() * p.y()) + height;
    }
    return internal::tree_of(mesh.points, mesh.triangles);
  };
  const Surface_tree low = sheet(0);
  for (double height : {0.5, 0.8, 1.3}) {
    const Surface_tree high = sheet(height);
    internal::contacts::Closest_pair closest;
    low.improve_closest(high, closest);
    const double exact = std::sqrt(closest.squared);
    for (double share : {0., 0.9, 0.99, 1.01}) {
      INFO("height " << height << " share " << share);
      const double enough = share * exact, most = std::max(enough, enough + (exact - enough) / 0.9);
      CHECK(std::sqrt(low.nearly_closest(high, enough).squared) <= most * (1 + 1e-9));
    }
  }
}

TEST_CASE("The least rotation turns one direction to the other, opposite ones too, by the angle between them")
{
  const std::vector<Point> directions = {Point::UnitX(),    Point::UnitY(),      Point::UnitZ(),
                                         Point(1, -2, 0.5), Point(-0.3, 0, 0.1), Point(1e-7, 1, 0)};
  for (const Point& from : directions)
    for (const Point& other : directions)
      for (const Point& to : {other, Point(-other), Point(-from)}) {
        INFO(from.transpose() << " to " << to.transpose());
        const Eigen::Quaterniond rotation = internal::least_rotation(from, to);
        CHECK(rotation.norm() == Approx(1));
        CHECK((rotation * from.normalized() - to.normalized()).norm() < 1e-6);
        const double cosine = from.normalized().dot(to.normalized());
        CHECK(2 * rotation.w() * rotation.w() - 1 == Approx(cosine).margin(1e-6));
      }
}

TEST_CASE("Of two assignments that are as good by relative places, distances choose one, not the order of parts")
{
  // In relative positions, either source block is equally far from both target blocks.
  const auto blocks = [](double z, bool is_first_left) {
    const box_models::Named_box left = {"left", {-0.5, 0.35, z}, {0.2, 0.5, 0.2}},
                                right = {"right", {0.5, 0.35, -z}, {0.2, 0.5, 0.2}};
    box_models::Box_model result = box_models::model_of(
        {{"base", {0, 0.05, 0}, {1.6, 0.1, 1}}, is_first_left ? left : right, is_first_left ? right : left});
    structure(result.graph).frame.axes.setIdentity();
    return result;
  };
  const box_models::Box_model source = blocks(0.2, true);
  for (bool is_first_left : {true, false}) {
    const box_models::Box_model target = blocks(-0.1, is_first_left);
    const std::array<internal::Blend_input, 2> inputs = {internal::Blend_input{source.graph, source.shape, 0},
                                                         internal::Blend_input{target.graph, target.shape, 0}};
    const internal::Blend_stage stage(inputs, Blend_size::SAME);
    const auto found =
        internal::matched_members(stage.charted[0], stage.charted[1], {{0, 0}, {1, 1}, {1, 2}, {2, 1}, {2, 2}});
    const std::size_t left = is_first_left ? 1 : 2;
    CHECK(found == Part_pairs{{0, 0}, {1, left}, {2, 3 - left}});
  }
}

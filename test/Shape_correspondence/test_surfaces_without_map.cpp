// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "blend/Blend_part.h"
#include "blend/Distance_grid.h"
#include "blend/Field_morph.h"
#include "blend/Rest_surface.h"
#include "blend/pair_boxes.h"
#include "blend_checks.h"
#include "box_models.h"
#include "map/Chart_outline.h"
#include "map/Piece_pair.h"

#include <CGAL/Shape_correspondence/IO/write_blend.h>
#include <CGAL/Shape_correspondence/blend_shapes.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

// Surfaces by distance fields, boxes of pairs, parts that draw back, and coordinates that do not tear.

using namespace CGAL::Shape_correspondence;
using Catch::Matchers::Contains;
using namespace box_models;

TEST_CASE("Surfaces of which one would be torn on its way to the other become each other by distance fields")
{
  // A board becomes bars side by side, with gaps that its surface would have to leave
  const Box_model board = model_of(stand());
  Box_model grille = model_of(stand());
  constexpr int count = 5;
  Part_mesh bars;
  for (int i = 0; i < count; ++i) {
    const Part_mesh bar = box_shapes::box({0.22 * (i - 2), 0.95, 0}, {0.1, 0.1, 0.6});
    const Eigen::Index points = bars.points.cols(), triangles = bars.triangles.cols();
    bars.points.conservativeResize(3, points + bar.points.cols());
    bars.points.rightCols(bar.points.cols()) = bar.points;
    bars.triangles.conservativeResize(3, triangles + bar.triangles.cols());
    bars.triangles.rightCols(bar.triangles.cols()) = bar.triangles.array() + int(points);
  }
  Segmented_shape with_bars("grille");
  for (const Shape_part& part : grille.shape.parts())
    with_bars.add_part(part.name, part.name == "top" ? bars : part.mesh);
  grille.shape = with_bars;
  const auto area = [](const Segmented_shape& of) { return blend_checks::area(of.parts()[2].mesh); };
  for (bool forward : {true, false}) {
    const Box_model &source = forward ? board : grille, &target = forward ? grille : board;
    const Shape_blend blend = blend_of(source, target, same_parts(3));
    const std::vector<Blend_task>& tasks = blend.schedules()[0].tasks;
    CHECK(tasks[0].obstacle == Blend_obstacle::NONE);
    CHECK(tasks[1].obstacle == Blend_obstacle::NONE);
    REQUIRE(tasks[2].obstacle == Blend_obstacle::TORN);
    for (double t : {0.1, 0.3, 0.5, 0.7, 0.9}) {
      INFO(t);
      const Blend_check check = blend.check(t);
      CHECK(check.faults.empty());
      CHECK(check.quality.torn == 0);
    }
    CHECK(area(blend(0)) == Approx(area(source.shape)).epsilon(0.01));
    CHECK(area(blend(1)) == Approx(area(target.shape)).epsilon(0.01));
    // One surface at any time, closed, as wide as the box that is due, which the board leaves as bars
    std::vector<Blend_surface> surfaces = blend.surfaces();
    surfaces.erase(std::remove_if(surfaces.begin(), surfaces.end(), [](const auto& s) { return s.name != "top~top"; }),
                   surfaces.end());
    REQUIRE(surfaces.size() > 4);
    CHECK(surfaces.front().begin == 0);
    CHECK(surfaces.back().end == 1);
    CHECK(surfaces.front().side == 0);
    CHECK(surfaces.back().side == 1);
    for (std::size_t i = 0; i + 1 < surfaces.size(); ++i)
      CHECK(surfaces[i].end == surfaces[i + 1].begin);
    for (double t : {0.3, 0.5, 0.7}) {
      const Part_mesh mesh = blend(t).parts()[2].mesh;
      CHECK(internal::Rest_surface(mesh.points, mesh.triangles).is_closed());
      CHECK(internal::box_of(mesh.points).sizes().x() == Approx(0.98).epsilon(0.02));
    }
    std::ostringstream json;
    IO::write_blend_json(json, blend, source.graph, target.graph, "a", "b", "c", 2, {});
    CHECK_THAT(json.str(), Contains("\"obstacle\":\"torn\""));
  }
  const Shape_blend same = blend_of(grille, grille, same_parts(3));
  for (const Blend_task& task : same.schedules()[0].tasks)
    CHECK(task.obstacle == Blend_obstacle::NONE);
}

TEST_CASE("A column grows out of the top and carries its foot down before the four legs have gone up")
{
  std::vector<Named_box> legged = {{"top", {0, 0.95, 0}, {1, 0.1, 1}}};
  for (double x : {-0.45, 0.45})
    for (double z : {-0.45, 0.45})
      legged.push_back({"leg_" + std::to_string(legged.size()), {x, 0.45, z}, {0.1, 0.9, 0.1}});
  const std::vector<Named_box> pedestal = {{"top", {0, 0.95, 0}, {1, 0.1, 1}},
                                           {"column", {0, 0.475, 0}, {0.4, 0.85, 0.4}},
                                           {"foot", {0.3, 0.025, 0}, {0.8, 0.05, 0.1}}};
  Correspondence correspondence = same_parts(1);
  for (std::size_t leg = 1; leg <= 4; ++leg)
    correspondence.pairs.push_back({leg, 1});
  const Box_model source = model_of(legged), target = model_of(pedestal);
  const Shape_blend blend = blend_of(source, target, correspondence);
  for (const Blend_task& task : blend.schedules()[0].tasks)
    CHECK(task.obstacle == (task.source == 0 ? Blend_obstacle::NONE : Blend_obstacle::UNLIKE));
  for (double t : {0.2, 0.405, 0.415, 0.43, 0.45, 0.46, 0.48, 0.495, 0.75}) {
    INFO(t);
    CHECK(blend.check(t).quality.height < 0.01);
    CHECK(blend.check(t).quality.apart <= Shape_blend::apart_tolerance);
    const Segmented_shape shape = blend(t);
    double column = 1, foot = 1, leg = 1; // how high the lowest point is
    for (const Shape_part& part : shape.parts()) {
      const internal::contacts::Box box = internal::box_of(part.mesh.points);
      if (part.name == "~column") column = box.min().y();
      if (part.name == "~foot") foot = box.min().y();
      if (part.name == "leg_1~") leg = box.min().y();
    }
    CHECK(std::min(foot, leg) < 0.01);                               // it stands
    if (foot < 1) CHECK(foot == Approx(column - 0.05).margin(0.06)); // and the foot hangs at the column
    CHECK((leg < 1) == (t < 0.49));
    CHECK((column < 1) == (t > 0.41));
  }
}

TEST_CASE("Of parts without counterpart, two alike in one place become each other; others come and go by themselves")
{
  std::vector<Named_box> armed = stand(), winged = stand();
  armed.push_back({"arm", {0, 1.2, 0.28}, {0.9, 0.4, 0.04}});
  winged.push_back({"wing", {0.02, 1.2, 0.28}, {0.8, 0.4, 0.04}});
  winged.push_back({"knob", {0, 1.02, -0.25}, {0.04, 0.04, 0.04}});
  const Shape_blend blend = blend_of(model_of(armed), model_of(winged), same_parts(3));
  for (const Blend_task& task : blend.schedules()[0].tasks) {
    CHECK((task.type == Blend_task_type::EXCHANGE) == (task.source == 3));
    CHECK(task.obstacle == Blend_obstacle::NONE);
    if (task.source == 3) CHECK(task.target == 3);
  }
  winged.push_back({"other", {-0.1, 1.2, 0.28}, {0.8, 0.4, 0.04}}); // not as much in its place
  const std::vector<Blend_task> tasks = blend_of(model_of(armed), model_of(winged), same_parts(3)).schedules()[0].tasks;
  CHECK(std::count_if(tasks.begin(), tasks.end(),
                      [](const Blend_task& task) { return task.type == Blend_task_type::EXCHANGE; }) == 1);
}

namespace {

/// A ring around the z axis, of radii 1 and 0.2.
Part_mesh ring()
{
  constexpr int around = 48, across = 12;
  Part_mesh result{Points(3, around * across), Eigen::Matrix3Xi(3, 2 * around * across)};
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      const double u = 2 * EIGEN_PI * i / around, v = 2 * EIGEN_PI * j / across, r = 1 + 0.2 * std::cos(v);
      const int next = (i + 1) % around, up = (j + 1) % across, point = i * across + j;
      result.points.col(point) << r * std::cos(u), r * std::sin(u), 0.2 * std::sin(v);
      result.triangles.col(2 * point) << point, next * across + j, next * across + up;
      result.triangles.col(2 * point + 1) << point, next * across + up, i * across + up;
    }
  return result;
}

/// Without the triangles that are in the highest plane.
Part_mesh without_lid(const Part_mesh& box)
{
  Part_mesh result{box.points, {}};
  const double high = box.points.row(1).maxCoeff();
  for (Eigen::Index t = 0; t < box.triangles.cols(); ++t) {
    if (box.points(Eigen::all, box.triangles.col(t)).row(1).minCoeff() > high - 1e-9) continue;
    result.triangles.conservativeResize(3, result.triangles.cols() + 1);
    result.triangles.rightCols(1) = box.triangles.col(t);
  }
  return result;
}

double volume(const Part_mesh& mesh) { return internal::Rest_surface(mesh.points, mesh.triangles).extent().volume; }

} // namespace

TEST_CASE("Signed distances on a grid are exact but for half of a cell, by which surfaces are thicker")
{
  const internal::Distance_grid grid(Point(1.5, 1, 0.5));
  const Part_mesh box = box_shapes::box({0, 0, 0}, {2, 1, 0.6});
  for (bool is_open : {false, true}) {
    Part_mesh surface = box;
    if (is_open) surface = without_lid(box);
    const internal::Distance_grid::Values values = grid.signed_distances(surface);
    INFO(is_open); // without its lid the box is a plate with rims
    const Part_mesh level_set = grid.level_set(values, is_open ? 0 : -grid.thickness());
    CHECK(internal::Rest_surface(level_set.points, level_set.triangles).is_closed());
    if (is_open)
      CHECK(volume(level_set) < 0.8 * volume(box));
    else
      CHECK(volume(level_set) == Approx(volume(box)).epsilon(0.05));
    CHECK(grid.pieces_below(values, 0) == 1);
    CHECK(grid.holes_below(values, 0) == -1); // a piece, no hole
  }
  const internal::Distance_grid::Values values = grid.signed_distances(box);
  const Points corners = grid.level_set(values, 0.1 - grid.thickness()).points; // 0.1 off all sides, round at edges
  CHECK(internal::box_of(corners).sizes().isApprox(Point(2.2, 1.2, 0.8), 0.02));
  CHECK(grid.extents_below(values, -grid.thickness()).isApprox(Point(2 / 3., 0.5, 0.6), 0.1));
}

TEST_CASE("Pieces and holes of what is inside are counted")
{
  const internal::Distance_grid grid(Point(1.3, 1.3, 0.3));
  const internal::Distance_grid::Values values = grid.signed_distances(ring());
  CHECK(grid.pieces_below(values, 0) == 1);
  CHECK(grid.holes_below(values, 0) == 0); // a piece with a hole
  Part_mesh two = box_shapes::box({-0.8, 0, 0}, {0.5, 0.5, 0.4});
  const Part_mesh other = box_shapes::box({0.8, 0, 0}, {0.5, 0.5, 0.4});
  const Eigen::Index points = other.points.cols(), triangles = other.triangles.cols();
  two.points.conservativeResize(3, 2 * points);
  two.points.rightCols(points) = other.points;
  two.triangles.conservativeResize(3, 2 * triangles);
  two.triangles.rightCols(triangles) = other.triangles.array() + int(points);
  const internal::Distance_grid::Values apart = grid.signed_distances(two);
  CHECK(grid.pieces_below(apart, 0) == 2);
  CHECK(grid.holes_below(apart, 0) == -2);
}

TEST_CASE("By distance fields a ring becomes a disc and keeps the box and the volume that are due")
{
  const Part_mesh hoop = ring(), disc = box_shapes::box({3, 0, 0}, {2, 2, 0.4});
  const Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  const internal::Field_morph morph(
      {internal::Part_chart::box(hoop.points, axes), internal::Part_chart::box(disc.points, axes)}, hoop, disc);
  REQUIRE(morph.holds_together());
  const int last = morph.number_of_surfaces() - 1;
  CHECK(morph.surface(0) == 0);
  CHECK(morph.surface(1) == last);
  CHECK((morph.points(0, 0) - hoop.points).cwiseAbs().maxCoeff() < 1e-12);
  CHECK((morph.points(last, 1) - disc.points).cwiseAbs().maxCoeff() < 1e-12);
  double before = volume(hoop);
  for (double t : {0.37, 0.44, 0.5, 0.56, 0.63}) {
    INFO(t);
    const int surface = morph.surface(t);
    CHECK(morph.surface(std::nextafter(morph.changes()[std::size_t(surface - 1)], 0)) == surface - 1);
    const Part_mesh mesh{morph.points(surface, t), morph.triangles(surface)};
    const internal::contacts::Box box = internal::box_of(mesh.points);
    CHECK(box.center().isApprox(Point(3 * t, 0, 0), 1e-6));
    CHECK(box.sizes().isApprox(Point(2.4 - 0.4 * t, 2.4 - 0.4 * t, 0.4), 1e-6));
    CHECK(internal::Rest_surface(mesh.points, mesh.triangles).is_closed());
    CHECK(volume(mesh) > before - 0.05);
    before = volume(mesh);
  }
  CHECK(before == Approx(volume(disc)).epsilon(0.1));
}

TEST_CASE("Where level sets would not fill their box, the one surface takes over from the other half-way")
{
  // A rod along one diagonal of the box, and one along the other: what is between is a blob in the middle
  const auto rod = [](double angle) {
    Part_mesh result = box_shapes::box({0, 0, 0}, {2, 0.04, 0.04});
    result.points = Eigen::AngleAxisd(angle, Point::UnitZ()).toRotationMatrix() * result.points;
    return result;
  };
  const Part_mesh up = rod(EIGEN_PI / 4), down = rod(-EIGEN_PI / 4);
  const Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  const internal::Field_morph morph(
      {internal::Part_chart::box(up.points, axes), internal::Part_chart::box(down.points, axes)}, up, down);
  CHECK(!morph.holds_together());
  CHECK(morph.changes() == std::vector<double>{0.5});
  CHECK(morph.points(0, 0.4).isApprox(up.points, 1e-9));
  CHECK(morph.points(1, 0.6).isApprox(down.points, 1e-9));
}

namespace {

/// Rods between points, as one surface.
Part_mesh rods(const std::vector<std::array<Point, 2>>& ends, double thickness)
{
  Part_mesh result;
  for (const auto& [a, b] : ends) {
    Part_mesh rod = box_shapes::box({0, 0, 0}, {(b - a).norm() + thickness, thickness, thickness});
    const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(Point::UnitX(), b - a);
    rod.points = (turn.toRotationMatrix() * rod.points).colwise() + (a + b) / 2;
    const Eigen::Index points = result.points.cols(), triangles = result.triangles.cols();
    result.points.conservativeResize(3, points + rod.points.cols());
    result.points.rightCols(rod.points.cols()) = rod.points;
    result.triangles.conservativeResize(3, triangles + rod.triangles.cols());
    result.triangles.rightCols(rod.triangles.cols()) = rod.triangles.array() + int(points);
  }
  return result;
}

} // namespace

TEST_CASE("Frames with less than half of the smaller in common do not swell into each other")
{
  constexpr double thickness = 0.1;
  const Part_mesh two = rods({{{{1, -1, -0.6}, {1, -1, 0.6}}}, {{{-1, 1, 0.6}, {1, 1, 0.6}}}}, thickness);
  const Part_mesh four = rods({{{{-1, -1, -0.6}, {-1, 1, -0.6}}},
                               {{{-1, -1, -0.6}, {-1, -1, 0.6}}},
                               {{{1, -1, -0.6}, {1, 1, -0.6}}},
                               {{{-1, 1, -0.6}, {-1, 1, 0.6}}}},
                              thickness);
  const auto holds = [](const Part_mesh& from, const Part_mesh& to) {
    const Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
    const auto chart = [&](const Part_mesh& mesh) { return internal::Part_chart::box(mesh.points, axes); };
    return internal::Field_morph({chart(from), chart(to)}, from, to).holds_together();
  };
  CHECK(!holds(two, four));
  CHECK(holds(two, two));
  CHECK(holds(four, four));
}

TEST_CASE("The axes of boxes are paired for the least rotation; a box has its own axes where they make it smaller")
{
  const auto charts = [](const Part_mesh& a, const Part_mesh& b, const Eigen::Matrix3d& a_axes,
                         const Eigen::Matrix3d& b_axes) {
    return internal::pair_boxes({&a.points, &b.points}, {a_axes, b_axes});
  };
  Eigen::Matrix3d other; // the same box with its axes in another order
  other << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  const Part_mesh cushion = box_shapes::box({0, 0, 0}, {1, 0.4, 0.9}), back = box_shapes::box({0, 0, 0}, {1, 0.9, 0.4});
  CHECK(internal::turn(charts(cushion, back, Eigen::Matrix3d::Identity(), other)) == Approx(0).margin(1e-6));
  constexpr double angle = 0.6;
  Part_mesh rod = box_shapes::box({0, 0, 0}, {0.05, 1, 0.05}), slanted = rod;
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, Point::UnitZ()).toRotationMatrix();
  slanted.points = turn * slanted.points;
  CHECK(internal::turn(charts(rod, slanted, Eigen::Matrix3d::Identity(), turn * other)) == Approx(angle));
  CHECK(internal::change(charts(rod, slanted, Eigen::Matrix3d::Identity(), turn * other)) == Approx(angle));
}

TEST_CASE("Coordinates relative to outlines: a round one and one with corners are the same disc")
{
  constexpr int around = 64;
  Points round(3, around), square(3, around);
  for (int i = 0; i < around; ++i) {
    const double angle = 2 * EIGEN_PI * i / around, c = std::cos(angle), s = std::sin(angle);
    round.col(i) << c, s, 0.5;
    square.col(i) << Point(c, s, 0) / std::max(std::abs(c), std::abs(s)) + Point(0, 0, 0.5);
  }
  const internal::Chart_outline disc(true, round), plate(true, square);
  for (int i = 0; i < around; ++i) {
    CHECK(plate.relative(square.col(i)).head<2>().norm() == Approx(1).epsilon(0.02));
    CHECK((plate.absolute(disc.relative(round.col(i))) - square.col(i)).norm() < 0.05);
    CHECK((plate.absolute(plate.relative(square.col(i))) - square.col(i)).norm() < 1e-12);
    CHECK((internal::Chart_outline::between(disc, plate, 1).absolute(round.col(i)) - plate.absolute(round.col(i)))
              .norm() < 1e-12);
  }
  const internal::Chart_outline flat(false, Points::Zero(3, 4)); // no outline at all
  CHECK((flat.absolute(flat.relative(Point(0.3, 0.2, 0.1))) - Point(0.3, 0.2, 0.1)).norm() < 1e-12);
}

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "blend/Blend_part.h"
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

// Surfaces that have no map onto each other, boxes of pairs, and coordinates that do not tear.

using namespace CGAL::Shape_correspondence;
using Catch::Matchers::Contains;
using namespace box_models;

TEST_CASE("Four legs are exchanged for a column with its foot in an instant: the shape stands before and after")
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
  for (const Blend_task& task : blend.schedules()[0].tasks) {
    const bool corresponds = task.source != 0 && task.target != 2; // the foot has no counterpart
    CHECK(task.obstacle == (corresponds ? Blend_obstacle::UNLIKE : Blend_obstacle::NONE));
  }
  for (double t : {0.2, 0.445, 0.45, 0.5, 0.75}) {
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
    CHECK((leg < 1) == (t < 0.45));
    CHECK((column < 1) == (t >= 0.45));
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
  winged.push_back({"other", {0.02, 1.2, 0.255}, {0.8, 0.4, 0.04}}); // not as much in its place
  const std::vector<Blend_task> tasks = blend_of(model_of(armed), model_of(winged), same_parts(3)).schedules()[0].tasks;
  CHECK(std::count_if(tasks.begin(), tasks.end(),
                      [](const Blend_task& task) { return task.type == Blend_task_type::EXCHANGE; }) == 1);
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
  const auto spine = [&](const Point& size) -> Point { // where the first axis points
    const Part_mesh part = box_shapes::box({0, 0, 0}, size);
    return charts(part, part, Eigen::Matrix3d::Identity(), Eigen::Matrix3d::Identity()).source.axes().col(0).cwiseAbs();
  };
  CHECK(spine({1, 0.6, 0.8}).isApprox(Point::UnitX())); // the longest one
  CHECK(spine({1, 0.6, 0.9}).isApprox(Point::UnitY())); // what may be round turns about the other one
  constexpr double angle = 0.6;
  Part_mesh rod = box_shapes::box({0, 0, 0}, {0.05, 1, 0.05}), slanted = rod;
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, Point::UnitZ()).toRotationMatrix();
  slanted.points = turn * slanted.points;
  CHECK(internal::turn(charts(rod, slanted, Eigen::Matrix3d::Identity(), turn * other)) == Approx(angle));
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

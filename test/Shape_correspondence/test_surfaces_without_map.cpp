// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "blend/Blend_part.h"
#include "blend/Surface_smoother.h"
#include "blend_checks.h"
#include "box_models.h"
#include "map/Chart_outline.h"
#include "map/Piece_pair.h"
#include "part_meshes.h"

#include <CGAL/Shape_correspondence/IO/write_blend.h>
#include <CGAL/Shape_correspondence/blend_shapes.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

// Surfaces without a map to each other, boxes of pairs, and coordinates that do not tear.

using namespace CGAL::Shape_correspondence;
using Catch::Matchers::Contains;
using namespace box_models;

namespace {

const Part_mesh ball = part_meshes::turned({{0, -0.5}, {0.3, -0.4}, {0.5, 0}, {0.3, 0.4}, {0, 0.5}});

} // namespace

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
    CHECK(blend_checks::height_error(blend, t) < 0.02);
    CHECK(blend.quality(t).apart <= 0.02);
    const Segmented_shape shape = blend(t);
    double column = 1, foot = 1, leg = 1; // heights of the lowest points
    for (const Shape_part& part : shape.parts()) {
      const internal::contacts::Box box = internal::box_of(part.mesh.points);
      if (part.name == "~column") column = box.min().y();
      if (part.name == "~foot") foot = box.min().y();
      if (part.name == "leg_1~") leg = box.min().y();
    }
    CHECK(std::min(foot, leg) < 0.01);                               // a part stands on the ground
    if (foot < 1) CHECK(foot == Approx(column - 0.05).margin(0.06)); // the foot is attached to the column
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
  winged.push_back({"other", {0.02, 1.2, 0.255}, {0.8, 0.4, 0.04}}); // shares less of its place
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
  const auto turn_of = [](const internal::Pair_charts& charts) {
    return Eigen::AngleAxisd(charts.target.axes() * charts.source.axes().transpose()).angle();
  };
  Eigen::Matrix3d other; // permutes the axes of the box
  other << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  const Part_mesh cushion = box_shapes::box({0, 0, 0}, {1, 0.4, 0.9}), back = box_shapes::box({0, 0, 0}, {1, 0.9, 0.4});
  CHECK(turn_of(charts(cushion, back, Eigen::Matrix3d::Identity(), other)) == Approx(0).margin(1e-6));
  const auto spine = [&](const Point& size) -> Point { // direction of the first axis
    const Part_mesh part = box_shapes::box({0, 0, 0}, size);
    return charts(part, part, Eigen::Matrix3d::Identity(), Eigen::Matrix3d::Identity()).source.axes().col(0).cwiseAbs();
  };
  CHECK(spine({1, 0.6, 0.8}).isApprox(Point::UnitX())); // the longest axis
  CHECK(spine({1, 0.6, 0.9}).isApprox(Point::UnitY())); // the axis of a part that may be round
  constexpr double angle = 0.6;
  Part_mesh rod = box_shapes::box({0, 0, 0}, {0.05, 1, 0.05}), slanted = rod;
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, Point::UnitZ()).toRotationMatrix();
  slanted.points = turn * slanted.points;
  CHECK(turn_of(charts(rod, slanted, Eigen::Matrix3d::Identity(), turn * other)) == Approx(angle));
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
  const internal::Chart_outline flat(false, Points::Zero(3, 4)); // no outline
  CHECK((flat.absolute(flat.relative(Point(0.3, 0.2, 0.1))) - Point(0.3, 0.2, 0.1)).norm() < 1e-12);
}

TEST_CASE("Displacements are smoothed over a length: a step becomes two exponentials; components are independent")
{
  constexpr int cells = 200;
  constexpr double step = 0.05, length = 0.5; // a strip from -5 to 5, of triangles that share no points
  Points strip(3, 6 * cells);
  Eigen::Matrix3Xi triangles(3, 2 * cells);
  for (int i = 0; i < cells; ++i) {
    const double x = (i - cells / 2) * step, next = (i + 1 - cells / 2) * step; // bitwise equal at shared ends
    strip.middleCols<6>(6 * i) << x, next, next, x, next, x, 0, 0, 1, 0, 1, 1, 0, 0, 0, 0, 0, 0;
    triangles.col(2 * i) << 6 * i, 6 * i + 1, 6 * i + 2;
    triangles.col(2 * i + 1) << 6 * i + 3, 6 * i + 4, 6 * i + 5;
  }
  Points ways = Points::Constant(3, strip.cols(), 0.7);
  CHECK((internal::Surface_smoother(strip, triangles)(ways, length) - ways).norm() < 1e-9);
  Points sliver = strip;
  sliver.row(1) *= 1e-9;
  CHECK((internal::Surface_smoother(sliver, triangles)(ways, length) - ways).norm() < 1e-9);
  for (Eigen::Index i = 0; i < strip.cols(); ++i)
    ways(0, i) = strip(0, i) < -step / 2 ? -1 : strip(0, i) > step / 2 ? 1 : 0;
  const Points joined = internal::Surface_smoother(strip, triangles)(ways, length);
  for (Eigen::Index i = 0; i < strip.cols(); ++i) {
    // Solution of w - l² w'' = given
    const double x = strip(0, i), due = std::copysign(1 - std::exp(-std::abs(x) / length), x);
    if (std::abs(x) < 2) CHECK(joined(0, i) == Approx(due).margin(0.02));
  }
  for (Eigen::Index i = 0; i < strip.cols() / 2; ++i)
    strip(1, i) += 10; // separates the left half
  const Points apart = internal::Surface_smoother(strip, triangles)(ways, length);
  CHECK(apart(0, strip.cols() - 1) == Approx(1).margin(1e-3));
  CHECK(apart(0, 0) == Approx(-1).margin(1e-3));
}

TEST_CASE("A sheet whose two sides coincide is not closed")
{
  Part_mesh sheet = part_meshes::without_triangles(ball, 1);
  const Eigen::Index half = sheet.triangles.cols();
  CHECK(internal::Rest_surface(ball.points, ball.triangles).is_closed());
  CHECK_FALSE(internal::Rest_surface(sheet.points, sheet.triangles).is_closed());
  sheet.triangles.conservativeResize(3, 2 * half);
  sheet.triangles.rightCols(half) = sheet.triangles.leftCols(half).colwise().reverse().eval();
  CHECK_FALSE(internal::Rest_surface(sheet.points, sheet.triangles).is_closed());
}

TEST_CASE("A cube becomes a ball: the surface that takes over lies on the other one, and nothing is torn")
{
  const Part_mesh cube = box_shapes::box({0, 0, 0}, {1, 1, 1});
  const Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  const internal::Part_morph morph(internal::pair_boxes({&cube.points, &ball.points}, {axes, axes}), cube, ball);
  CHECK(morph.misfit(false) > 0.15);
  CHECK(morph.misfit(true) < 0.03);
  const internal::contacts::Triangle_tree tree =
      internal::tree_of(morph.points(0, internal::Part_morph::change), morph.triangles(0));
  const Points second = morph.points(1, internal::Part_morph::change);
  double sum = 0;
  for (Eigen::Index i = 0; i < second.cols(); ++i) {
    std::size_t triangle = 0;
    sum += (tree.nearest(second.col(i), triangle) - second.col(i)).squaredNorm();
  }
  CHECK(std::sqrt(sum / double(second.cols())) < 0.02);
  for (int surface : {0, 1}) {
    const internal::Rest_surface rest(morph.points(surface, surface), morph.triangles(surface));
    for (double t : {0.2, 0.45, 0.7}) {
      const Points points = morph.points(surface, t);
      CHECK(rest.torn_area(points) < 0.01 * rest.area(points));
    }
  }
}

TEST_CASE("A closed surface may differ more from its counterpart than one with borders, where gaps would be visible")
{
  const auto stand_with = [](const Part_mesh& top) {
    Segmented_shape shape("stand");
    shape.add_part("base", box_shapes::box({0, -0.6, 0}, {1, 0.2, 1}));
    shape.add_part("top", top);
    Box_model result = model_of(shape);
    structure(result.graph).frame.axes.setIdentity();
    return result;
  };
  const Box_model cube = stand_with(box_shapes::box({0, 0, 0}, {1, 1, 1}));
  const auto top_of = [&](const Part_mesh& source) {
    return blend_of(stand_with(source), cube, same_parts(2)).schedules()[0].tasks[1];
  };
  CHECK(top_of(ball).type == Blend_task_type::MORPH);
  CHECK(top_of(part_meshes::without_triangles(ball, 1)).type == Blend_task_type::SHRINK);
  CHECK(top_of(part_meshes::without_triangles(ball, 1)).obstacle == Blend_obstacle::TORN);
}

TEST_CASE("A post that becomes much longer is exchanged, one that becomes a little longer morphs")
{
  const auto posts = [](double height) {
    return model_of({{"base", {0, 0.05, 0}, {1, 0.1, 0.6}},
                     {"wall", {-0.45, 0.6, 0}, {0.1, 1, 0.6}},
                     {"post", {0.4, 0.1 + height / 2, 0}, {0.1, height, 0.1}}});
  };
  const auto post_from = [&](double height) {
    return blend_of(posts(height), posts(0.9), same_parts(3)).schedules()[0].tasks[2].type;
  };
  CHECK(post_from(0.6) == Blend_task_type::MORPH);
  CHECK(post_from(0.45) == Blend_task_type::SHRINK); // twice as long
}

TEST_CASE("A slanted bar that becomes much longer is exchanged, too, though the whole stays as it is")
{
  const auto with_bar = [](double length) {
    const Eigen::Matrix3d slant = Eigen::AngleAxisd(std::atan(1.), Point::UnitZ()).toRotationMatrix();
    Part_mesh bar = box_shapes::box({0, 0, 0}, {length, 0.06, 0.06});
    bar.points = (slant * bar.points).colwise() + Point(0.1, 0.6, 0);
    Segmented_shape shape("frame");
    shape.add_part("base", box_shapes::box({0, 0.05, 0}, {1, 0.1, 0.6}));
    shape.add_part("wall", box_shapes::box({-0.45, 0.6, 0}, {0.1, 1, 0.6}));
    shape.add_part("bar", bar);
    Box_model result = model_of(shape);
    structure(result.graph).frame.axes.setIdentity();
    return result;
  };
  const auto bar_from = [&](double length) {
    return blend_of(with_bar(length), with_bar(0.77), same_parts(3)).schedules()[0].tasks[2].type;
  };
  CHECK(bar_from(0.6) == Blend_task_type::MORPH);
  CHECK(bar_from(0.35) == Blend_task_type::SHRINK);
}

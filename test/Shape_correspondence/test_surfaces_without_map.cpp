// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "blend/Blend_part.h"
#include "blend_checks.h"
#include "box_models.h"
#include "map/Charted_mesh.h"
#include "map/Part_chart.h"
#include "map/Piece_pair.h"
#include "part_meshes.h"

#include <CGAL/Shape_correspondence/IO/write_blend.h>
#include <CGAL/Shape_correspondence/blend_shapes.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

// Morphs of parts whose surfaces have no map to each other: their boxes, outlines and shapes, and which parts morph.

using namespace CGAL::Shape_correspondence;
using Catch::Matchers::Contains;
using namespace box_models;

namespace {

const Part_mesh ball = part_meshes::turned({{0, -0.5}, {0.3, -0.4}, {0.5, 0}, {0.3, 0.4}, {0, 0.5}});

/// Coordinates of two parts in their bounding boxes, with y as the first axis.
internal::Pair_charts upright(const Part_mesh& source, const Part_mesh& target)
{
  Eigen::Matrix3d axes;
  axes << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  return {internal::Part_chart::box(source.points, axes), internal::Part_chart::box(target.points, axes)};
}

internal::Part_morph morph_of(const Part_mesh& source, const Part_mesh& target, bool bends = true)
{
  return {upright(source, target), source, target, bends};
}

std::shared_ptr<const internal::Part_morph> best_morph(const Part_mesh& source, const Part_mesh& target)
{
  return internal::best_morph({{upright(source, target)}}, source, target);
}

/// The largest distance, at time t, of vertices of the surface that is shown from the surface that is not.
double distance_at(const internal::Part_morph& morph, double t)
{
  const int present = morph.surface(t);
  const internal::contacts::Triangle_tree other =
      internal::tree_of(morph.points(1 - present, t), morph.triangles(1 - present));
  const Points points = morph.points(present, t);
  double farthest = 0;
  for (const auto& p : points.colwise()) {
    std::size_t triangle = 0;
    farthest = std::max(farthest, (other.nearest(p, triangle) - p).norm());
  }
  return farthest;
}

/// A ladder with four rungs that lies in the plane y = 0.
Part_mesh ladder()
{
  constexpr double thickness = 0.2, width = 0.0875;
  Part_mesh result = part_meshes::joined(box_shapes::box({0, 0, 0.52}, {1, thickness, 0.04}),
                                         box_shapes::box({0, 0, -0.52}, {1, thickness, 0.04}));
  for (double x : {-0.375, -0.125, 0.125, 0.375})
    result = part_meshes::joined(result, box_shapes::box({x, 0, 0}, {width, thickness, 1}));
  return result;
}

} // namespace

TEST_CASE("Four legs are exchanged for a column with its foot: the shape stands all the time")
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
  for (double t : {0.2, 0.38, 0.445, 0.45, 0.5, 0.75}) {
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

TEST_CASE(
    "Of parts without counterpart, two similar ones in one place are exchanged; others appear and vanish by themselves")
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
  winged.push_back({"other", {0.02, 1.2, 0.255}, {0.8, 0.4, 0.04}}); // has less space in common with the arm
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
  constexpr double angle = 0.6;
  Part_mesh rod = box_shapes::box({0, 0, 0}, {0.05, 1, 0.05}), slanted = rod;
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, Point::UnitZ()).toRotationMatrix();
  slanted.points = turn * slanted.points;
  CHECK(turn_of(charts(rod, slanted, Eigen::Matrix3d::Identity(), turn * other)) == Approx(angle));
}

TEST_CASE("Coordinates relative to outlines are in the unit disc, for round parts and for parts with corners")
{
  const auto outline_of = [](const Part_mesh& mesh) {
    const internal::Part_chart chart = internal::Part_chart::box(mesh.points, Eigen::Matrix3d::Identity());
    const internal::Charted_mesh fine = internal::charted_mesh(mesh, chart, 0.1);
    return std::pair(internal::Chart_outline(fine.coordinates, fine.triangles), fine.coordinates);
  };
  const auto [round, on_ball] = outline_of(ball);
  const auto [square, on_box] = outline_of(box_shapes::box({0, 0, 0}, {2, 0.6, 0.4}));
  for (const auto& k : on_box.colwise()) {
    const bool is_cap = std::abs(k[0]) > 0.99;
    if (!is_cap) CHECK(square.relative(k).tail<2>().norm() == Approx(1).epsilon(0.03));
    CHECK((square.absolute(square.relative(k)) - k).norm() < 1e-12);
    CHECK((internal::Chart_outline::between(round, square, 1).absolute(k) - square.absolute(k)).norm() < 1e-12);
  }
  for (const auto& k : on_ball.colwise())
    if (std::abs(k[0]) < 0.9) CHECK(round.relative(k).tail<2>().norm() == Approx(1).epsilon(0.1));
  const internal::Chart_outline none(Points::Zero(3, 4), Eigen::Matrix3Xi(3, 0));
  CHECK((none.absolute(none.relative(Point(0.3, 0.2, 0.1))) - Point(0.3, 0.2, 0.1)).norm() < 1e-12);
}

TEST_CASE("Smoothed outlines have no corners, but keep their extents where these are even")
{
  const Part_mesh board = box_shapes::box({0, 0, 0}, {2, 0.6, 0.4});
  const internal::Part_chart chart = internal::Part_chart::box(board.points, Eigen::Matrix3d::Identity());
  const internal::Charted_mesh fine = internal::charted_mesh(board, chart, 0.1);
  const internal::Chart_outline outline = internal::Chart_outline(fine.coordinates, fine.triangles).smoothed();
  CHECK(outline.absolute({0.3, 1, 0}).isApprox(Point(0.3, 1, 0), 0.03));
  const double corner = outline.absolute({0.3, std::sqrt(0.5), std::sqrt(0.5)}).tail<2>().norm();
  CHECK(corner > 1.2);
  CHECK(corner < 0.97 * std::sqrt(2.));
}

TEST_CASE("A cylinder becomes a cone: every section shrinks evenly")
{
  const Part_mesh cylinder = part_meshes::turned({{0, -0.5}, {0.4, -0.5}, {0.4, 0.5}, {0, 0.5}}),
                  cone = part_meshes::turned({{0, -0.5}, {0.4, -0.5}, {0.2, 0.5}, {0, 0.5}});
  const internal::Part_morph morph = morph_of(cylinder, cone);
  CHECK(morph.is_faithful());
  CHECK(morph.misfit() < 0.005);
  for (double t : {0.1, 0.3, 0.44, 0.46, 0.7, 0.9}) {
    INFO(t);
    const Points points = morph.points(morph.surface(t), t);
    double low = 0, high = 0; // radii at both ends
    for (const auto& p : points.colwise())
      if (std::abs(p.y()) > 0.49) (p.y() < 0 ? low : high) = std::max(p.y() < 0 ? low : high, std::hypot(p.x(), p.z()));
    CHECK(low == Approx(0.4).margin(0.01));
    CHECK(high == Approx(0.4 - 0.2 * t).margin(0.02));
  }
}

TEST_CASE("A square top becomes a round one: it stays flat, and the surface that takes over lies on the other one")
{
  const Part_mesh square = box_shapes::box({0, 0, 0}, {1, 0.1, 1}),
                  round = part_meshes::turned({{0, -0.05}, {0.5, -0.05}, {0.5, 0.05}, {0, 0.05}});
  const auto morph = best_morph(square, round);
  REQUIRE(morph);
  CHECK(morph->misfit() < 0.01);
  CHECK(morph->strain() > 0.05);
  for (double t : {0.1, 0.3, 0.44, 0.46, 0.7}) {
    INFO(t);
    const int surface = morph->surface(t);
    const Points points = morph->points(surface, t);
    for (const auto& p : points.colwise())
      if (std::hypot(p.x(), p.z()) < 0.3) CHECK(std::abs(p.y()) == Approx(0.05));
    const double area = blend_checks::area({points, morph->triangles(surface)}),
                 due = (1 - t) * blend_checks::area(square) + t * blend_checks::area(round);
    CHECK(area == Approx(due).epsilon(0.04));
  }
  CHECK(distance_at(*morph, 0.38) < 0.1);
  CHECK(distance_at(*morph, 0.4499) < 0.7 * distance_at(*morph, 0.38));
}

TEST_CASE("A part that is like its counterpart in a common box keeps its shape, and fits it just before the exchange")
{
  const Part_mesh post = box_shapes::box({0, 0, 0}, {0.1, 1, 0.1}),
                  tapered = part_meshes::turned({{0, -0.5}, {0.05, -0.5}, {0.04, 0.5}, {0, 0.5}});
  const auto morph = best_morph(post, tapered);
  REQUIRE(morph);
  CHECK(morph->strain() == 0);
  CHECK(morph->points(0, 0.38).isApprox(post.points, 1e-9));
  CHECK(morph->points(1, 0.52).isApprox(tapered.points, 1e-9));
  CHECK(distance_at(*morph, 0.4499) < 0.7 * distance_at(*morph, 0.38));
}

TEST_CASE("What would bend much does not morph, nor does a ladder to a board")
{
  const Part_mesh cube = box_shapes::box({0, 0, 0}, {1, 1, 1});
  CHECK(morph_of(cube, cube).is_faithful());
  CHECK_FALSE(morph_of(cube, ball).is_faithful());
  CHECK(morph_of(cube, ball).strain() > 0.2);
  const Part_mesh board = box_shapes::box({0, 0, 0}, {1, 0.2, 1.08});
  CHECK(morph_of(ladder(), ladder(), false).is_faithful());
  CHECK(morph_of(ladder(), board, false).effort() < 0.03);
  CHECK_FALSE(morph_of(ladder(), board, false).is_faithful());
}

TEST_CASE("A mesh is subdivided only where its morph bends it")
{
  const auto points = [](const Part_mesh& a, const Part_mesh& b) {
    const auto morph = best_morph(a, b);
    REQUIRE(morph);
    return morph->points(0, 0).cols();
  };
  const Part_mesh board = box_shapes::box({0, 0, 0}, {1, 0.1, 0.6});
  CHECK(points(board, box_shapes::box({0, 0.3, 0}, {1.4, 0.06, 0.7})) == board.points.cols());
  CHECK(points(board, part_meshes::turned({{0, -0.05}, {0.5, -0.05}, {0.5, 0.05}, {0, 0.05}})) >
        2 * board.points.cols());
}

TEST_CASE("A part becomes any other length, unless it would come off what it holds")
{
  const auto stand_of = [](double height, bool has_wall, bool has_crest) {
    std::vector<Named_box> result = {{"base", {0, 0.05, 0}, {1, 0.1, 0.6}},
                                     {"post", {0.4, 0.1 + height / 2, 0}, {0.1, height, 0.1}}};
    if (has_crest) result.push_back({"crest", {0, 1.05, 0}, {0.9, 0.1, 0.1}});
    if (has_wall) result.push_back({"wall", {-0.45, 0.55, 0}, {0.1, 0.9, 0.6}});
    return model_of(result);
  };
  const auto task_of_post = [&](const Box_model& source, const Box_model& target, std::size_t pairs) {
    return blend_of(source, target, same_parts(pairs)).schedules()[0].tasks[1];
  };
  CHECK(task_of_post(stand_of(0.9, false, false), stand_of(0.3, true, false), 2).type == Blend_task_type::MORPH);
  const auto tasks =
      blend_of(stand_of(0.9, false, true), stand_of(0.3, true, true), same_parts(3)).schedules()[0].tasks;
  for (const Blend_task& task : tasks)
    CHECK((task.obstacle == Blend_obstacle::UNLIKE) == (task.source == 1 || task.target == 1));
}

TEST_CASE("Of the parts of a symmetry group, all morph or none does")
{
  // A crest is on only one of three posts in a row. If this post morphed, it would come off the crest.
  const auto stand_of = [](double height) {
    std::vector<Named_box> result = {{"base", {0, 0.05, 0}, {1, 0.1, 0.6}}};
    for (double x : {-0.4, -0.05, 0.3})
      result.push_back({"post " + std::to_string(result.size()), {x, 0.1 + height / 2, 0}, {0.1, height, 0.1}});
    result.push_back({"crest", {0.3, 1.05, 0}, {0.2, 0.1, 0.4}});
    return model_of(result);
  };
  const Shape_blend blend = blend_of(stand_of(0.9), stand_of(0.3), same_parts(5));
  for (const Blend_task& task : blend.schedules()[0].tasks) {
    const std::size_t part = std::min(task.source, task.target);
    CHECK((task.obstacle == Blend_obstacle::UNLIKE) == (part >= 1 && part <= 3));
  }
}

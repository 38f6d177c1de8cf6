// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "blend/Blend_part.h"
#include "blend/Part_morph.h"
#include "blend/Rest_surface.h"
#include "blend/Retreating_part.h"
#include "blend/ease.h"
#include "blend/exchange.h"
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

// Surfaces that are exchanged, boxes of pairs, parts that thin, and coordinates that do not tear.

using namespace CGAL::Shape_correspondence;
using Catch::Matchers::Contains;
using namespace box_models;

TEST_CASE("Surfaces of which one would be torn on its way to the other are exchanged")
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
    CHECK(tasks[0].exchange == Blend_exchange::NONE);
    CHECK(tasks[1].exchange == Blend_exchange::NONE);
    REQUIRE(tasks[2].exchange == Blend_exchange::TORN);
    for (double t : {0.1, 0.3, 0.5, 0.7, 0.9}) {
      INFO(t);
      const Blend_check check = blend.check(t);
      CHECK(check.faults.empty());
      CHECK(check.quality.torn == 0);
    }
    // Both are there when the one takes over, but one alone half-way; each comes from nothing or goes to nothing
    const auto at_progress = [&](double progress) {
      return tasks[2].begin + internal::time_of(progress) * (tasks[2].end - tasks[2].begin);
    };
    CHECK(area(blend(at_progress(internal::in_place.come[1]))) ==
          Approx(area(source.shape) + area(target.shape)).epsilon(0.05));
    CHECK(area(blend(at_progress(0.25))) == Approx(area(source.shape)).epsilon(0.05));
    CHECK(area(blend(at_progress(0.5))) == Approx(area(target.shape)).epsilon(0.05));
    CHECK(area(blend(0)) == Approx(area(source.shape)).epsilon(0.01));
    CHECK(area(blend(1)) == Approx(area(target.shape)).epsilon(0.01));
    const std::vector<Blend_surface> surfaces = blend.surfaces();
    const auto first =
        std::find_if(surfaces.begin(), surfaces.end(), [](const auto& s) { return s.name == "top~top"; });
    REQUIRE(first + 1 < surfaces.end());
    CHECK(first->begin == 0);
    CHECK(first->end <= tasks[2].end);
    CHECK((first + 1)->begin >= tasks[2].begin);
    CHECK((first + 1)->begin < first->end);
    CHECK((first + 1)->end == 1);
    const auto at = std::size_t(first - surfaces.begin());
    const auto extent = [&](double t, std::size_t surface) { // of the thickness
      return internal::box_of(blend.points(t)[surface]).sizes().minCoeff();
    };
    CHECK(extent((first + 1)->begin, at + 1) < 1e-6);
    CHECK(extent(first->end, at) < 1e-6);
    std::ostringstream json;
    IO::write_blend_json(json, blend, source.graph, target.graph, "a", "b", "c", 2, {});
    CHECK_THAT(json.str(), Contains("\"exchanged\":\"torn\""));
  }
  const Shape_blend same = blend_of(grille, grille, same_parts(3));
  for (const Blend_task& task : same.schedules()[0].tasks)
    CHECK(task.exchange == Blend_exchange::NONE);
}

TEST_CASE("A column grows out of the top and carries its foot down before half of the four legs has gone up")
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
    CHECK(task.exchange == (task.source == 0 ? Blend_exchange::NONE : Blend_exchange::UNLIKE));
  for (double t : {0.2, 0.24, 0.3, 0.375, 0.45, 0.5, 0.55, 0.625, 0.75}) {
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
    CHECK((leg < 1) == (t < 0.67));
    CHECK((column < 1) == (t > 0.25));
  }
}

TEST_CASE("Of parts without counterpart, two alike in one place are exchanged; others come and go by themselves")
{
  std::vector<Named_box> armed = stand(), winged = stand();
  armed.push_back({"arm", {0, 1.2, 0.28}, {0.9, 0.4, 0.04}});
  winged.push_back({"wing", {0.02, 1.2, 0.28}, {0.8, 0.4, 0.04}});
  winged.push_back({"knob", {0, 1.02, -0.25}, {0.04, 0.04, 0.04}});
  const Shape_blend blend = blend_of(model_of(armed), model_of(winged), same_parts(3));
  for (const Blend_task& task : blend.schedules()[0].tasks) {
    CHECK((task.type == Blend_task_type::EXCHANGE) == (task.source == 3));
    CHECK((task.exchange == Blend_exchange::UNMATCHED) == (task.source == 3));
    if (task.source == 3) CHECK(task.target == 3);
  }
  winged.push_back({"other", {-0.1, 1.2, 0.28}, {0.8, 0.4, 0.04}}); // not as much in its place
  const std::vector<Blend_task> tasks = blend_of(model_of(armed), model_of(winged), same_parts(3)).schedules()[0].tasks;
  CHECK(std::count_if(tasks.begin(), tasks.end(),
                      [](const Blend_task& task) { return task.exchange == Blend_exchange::UNMATCHED; }) == 1);
}

TEST_CASE("What is exchanged is as it is at its own end, and goes from there to nothing without being torn")
{
  // A hoop becomes a board, in a chart of the hoop's kind or in straight ones
  constexpr int around = 24, across = 8;
  Part_mesh hoop{Points(3, around * across), Eigen::Matrix3Xi(3, 2 * around * across)};
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      const double u = 2 * EIGEN_PI * i / around, v = 2 * EIGEN_PI * j / across, r = 1 + 0.1 * std::cos(v);
      const int next = (i + 1) % around, up = (j + 1) % across, point = i * across + j;
      hoop.points.col(point) << r * std::cos(u), r * std::sin(u), 0.1 * std::sin(v);
      hoop.triangles.col(2 * point) << point, next * across + j, next * across + up;
      hoop.triangles.col(2 * point + 1) << point, next * across + up, i * across + up;
    }
  const Part_mesh board = box_shapes::box({3, 0, 0}, {1, 3, 0.2});
  const Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  for (bool are_plates : {false, true}) {
    const auto chart = are_plates ? internal::Part_chart::plate : internal::Part_chart::box;
    const auto morph =
        internal::Part_morph::exchange({chart(hoop.points, axes), chart(board.points, axes)}, hoop, board);
    CHECK(morph.is_exchange());
    for (int end : {0, 1}) {
      const Points& own = end == 0 ? hoop.points : board.points;
      CHECK((morph.points(end, end) - own).cwiseAbs().maxCoeff() < 1e-12);
      const internal::Rest_surface rest(own, morph.triangles(end));
      for (double t : {0.2, 0.5, 0.8}) {
        const Points half_way = morph.points(end, t), little = morph.points(end, t, 0.125);
        CHECK(rest.torn_area(half_way, rest.extent(half_way)) == 0);
        // A plate thins, a block shrinks: an eighth of the volume remains
        const Point left = are_plates ? Point(1, 1, 0.125) : Point(0.5, 0.5, 0.5);
        const Point sizes = internal::box_of(half_way).sizes();
        CHECK(internal::box_of(little).sizes().isApprox(left.cwiseProduct(sizes), 1e-9));
        CHECK(internal::box_of(half_way).center().x() == Approx(3 * t).margin(1e-9));
      }
      CHECK(internal::in_place.remaining(end, end) == 1);
      CHECK(internal::in_place.remaining(end, internal::in_place.come[1]) == 1);
      CHECK(internal::in_place.remaining(end, 0.5) == end);
      CHECK(internal::in_place.remaining(end, 1 - end) == 0);
    }
    const Point sizes = internal::box_of(morph.points(0, 0.5)).sizes();
    CHECK(sizes.x() == Approx((2.2 + 1) / 2));
    CHECK(sizes.y() == Approx((2.2 + 3) / 2));
    CHECK(sizes.z() == Approx(0.2));
  }
}

TEST_CASE("A rod that is exchanged for a net is not a block half-way: extents across go by equal factors")
{
  const Part_mesh rod = box_shapes::box({0, 0, 0}, {4, 0.1, 0.1}), net = box_shapes::box({0, 0, 0}, {4, 1.6, 0.1});
  const Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  const auto morph = internal::Part_morph::exchange(
      {internal::Part_chart::box(rod.points, axes), internal::Part_chart::box(net.points, axes)}, rod, net);
  CHECK(internal::box_of(morph.points(0, 0.5)).sizes().isApprox(Point(4, 0.4, 0.1)));
  CHECK(internal::box_of(morph.points(1, 0.5, 0.25)).sizes().isApprox(Point(4, 0.2, 0.05)));
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

TEST_CASE("A part without counterpart draws back into what carries it")
{
  using Roots = std::vector<Point>;
  const Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  const auto box_when = [&](const Part_mesh& mesh, const Roots& roots, double remaining, bool joins = false) {
    const internal::Retreating_part part(mesh, axes, roots, joins);
    CHECK(part.points(1) == mesh.points);
    CHECK((part.points(remaining).col(0) - part.place(mesh.points.col(0), remaining)).norm() < 1e-12);
    CHECK(part.place(part.root(), remaining).isApprox(part.root(), 1e-12));
    const Point left = internal::box_of(part.points(0)).sizes(); // a point, or a line between roots at both ends
    CHECK(left.sum() - left.maxCoeff() < 1e-12);
    return internal::box_of(part.points(remaining));
  };
  const auto is_box = [](const internal::contacts::Box& box, const Point& low, const Point& high) {
    return (box.min() - low).norm() < 1e-12 && (box.max() - high).norm() < 1e-12;
  };
  // A leg into the seat, also where an apron touches its side; a foot goes to the ground
  const Part_mesh leg = box_shapes::box({0, 0.5, 0}, {0.1, 1, 0.1});
  for (const Roots& roots : {Roots{{0, 1, 0}}, Roots{{0, 1, 0}, {0.05, 0.9, 0}}}) {
    const internal::contacts::Box box = box_when(leg, roots, 0.5);
    CHECK(box.max().y() == Approx(roots.size() == 1 ? 1 : 0.975));
    CHECK(box.sizes().isApprox(Point(0.1, 0.5, 0.1)));
  }
  CHECK(is_box(box_when(leg, {{0, 0, 0}}, 0.4), {-0.05, 0, -0.05}, {0.05, 0.4, 0.05}));
  // A cushion onto the seat; when little remains, it shrinks in all directions
  const Part_mesh cushion = box_shapes::box({0, 0.1, 0}, {1, 0.2, 0.8});
  CHECK(is_box(box_when(cushion, {{0, 0, 0}}, 0.5), {-0.5, 0, -0.4}, {0.5, 0.1, 0.4}));
  CHECK(box_when(cushion, {{0, 0, 0}}, 0.15).sizes().isApprox(Point(0.5, 0.03, 0.4)));
  // A slat that is carried at both ends goes downwards, a rail from left to right to the middle of its ends, one from
  // front to back to the back
  CHECK(is_box(box_when(leg, {{0, 0, 0}, {0, 1, 0}}, 0.4), {-0.05, 0, -0.05}, {0.05, 0.4, 0.05}));
  const Part_mesh rail = box_shapes::box({0, 0, 0}, {1, 0.1, 0.1}), side = box_shapes::box({0, 0, 0}, {0.1, 0.1, 1});
  CHECK(is_box(box_when(rail, {{-0.5, 0, 0}, {0.5, 0, 0}}, 0.5), {-0.5, -0.025, -0.025}, {0.5, 0.025, 0.025}));
  CHECK(is_box(box_when(side, {{0, 0, -0.5}, {0, 0, 0.5}}, 0.5), {-0.05, -0.05, -0.5}, {0.05, 0.05, 0}));
  // What alone joins two parts thins
  CHECK(is_box(box_when(leg, {{0, 0, 0}, {0, 1, 0}}, 0.5, true), {-0.025, 0, -0.025}, {0.025, 1, 0.025}));
  // A wheel into its hub as a whole
  CHECK(box_when(box_shapes::box({0, 0, 0}, {1, 1, 0.1}), {{0, 0, 0}}, 0.5).sizes().isApprox(Point(0.5, 0.5, 0.05)));
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

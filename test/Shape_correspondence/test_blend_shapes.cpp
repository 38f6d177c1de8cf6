// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "blend_models.h"
#include "box_shapes.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <thread>

// All in-between shapes: closed parts, connected, symmetric, on the ground; the ends are the inputs.

using namespace blend_models;

namespace {

constexpr double wider = 0.005; // largest accepted gap or asymmetry, over the shape's height

} // namespace

TEST_CASE("Contacts are kept where sets of parts come apart and are moved together")
{
  const Model &chair = model("chair_four_legged"), &other = model("chair_spindle");
  Correspondence few; // most parts that connect the parts of these pairs have no counterpart
  for (const auto& [from, to] :
       {std::pair("front_apron", "h_cross"), std::pair("front_right_leg", "turned_leg_b"),
        std::pair("left_back_post", "spindle_mid"), std::pair("rear_right_leg", "turned_leg_d"),
        std::pair("right_back_post", "spindle_2_r"), std::pair("right_back_post", "spindle_3_r"),
        std::pair("seat", "saddle_seat")})
    few.pairs.push_back({part_named(chair, from), part_named(other, to)});
  const Measured_blend blend(chair, other, few);
  for (double t : {0.1, 0.3, 0.5, 0.7, 0.9})
    CHECK(blend.gap(t) < wider);
}

TEST_CASE("A symmetric part stays symmetric when it is moved back into contact with the part that it has left")
{
  const Model &chair = model("chair_four_legged"), &stool = model("stool");
  Correspondence few;
  for (const auto& [from, to] : {std::pair("front_left_leg", "splay_1"), std::pair("rear_left_leg", "splay_3"),
                                 std::pair("rear_right_leg", "splay_4"), std::pair("seat", "round_board")})
    few.pairs.push_back({part_named(chair, from), part_named(stool, to)});
  const Measured_blend blend(chair, stool, few);
  for (double t : {0.2, 0.4, 0.6, 0.8})
    CHECK(blend.asymmetry(t) < 0.002);
}

TEST_CASE("Shapes between two models are closed, connected, symmetric and supported; the ends are the models")
{
  const std::vector<std::pair<std::string, std::string>> pairs = {{"chair_four_legged", "chair_slatted"},
                                                                  {"chair_spindle", "stool"}};
  for (const auto& [source, target] : pairs) {
    INFO(source << " and " << target);
    const Shape_blend blend = blend_of(source, target);
    const Measured_blend measured = measured_blend(source, target);
    CHECK(is_moved(blend(0), model(source).shape));
    CHECK(is_moved(blend(1), model(target).shape));
    CHECK(distance(blend(0), blend(1e-6)) < 1e-4);
    CHECK(distance(blend(1), blend(1 - 1e-6)) < 1e-4);
    CHECK(seen_distance(blend(1e-6), blend(0), 1) < 0.005);
    CHECK(seen_distance(blend(1 - 1e-6), blend(1), 1) < 0.005);
    for (double t : {0.1, 0.5, 0.8}) {
      INFO("t = " << t);
      const Segmented_shape shape = blend(t);
      for (const Shape_part& part : shape.parts()) {
        INFO(part.name);
        CHECK(is_closed(part.mesh));
      }
      CHECK(measured.gap(t) <= wider);
      CHECK(measured.asymmetry(t) <= wider);
      CHECK(height_error(blend, t) < 0.01);
      CHECK(blend.quality(t).support <= 0.4);
    }
  }
}

TEST_CASE("Parts too unlike to morph vanish or appear instead of being cut into pieces, and parts keep their contacts")
{
  for (const auto& [source, target] :
       {std::pair("chair_four_legged", "chair_slatted"), std::pair("chair_spindle", "chair_swivel")}) {
    INFO(source << " and " << target);
    const Shape_blend blend = blend_of(source, target);
    std::array<std::size_t, 2> unlike = {0, 0};
    for (const Blend_task& task : blend.schedules()[0].tasks)
      if (task.obstacle == Blend_obstacle::UNLIKE) {
        CHECK((task.type == Blend_task_type::SHRINK || task.type == Blend_task_type::GROW));
        ++unlike[task.type == Blend_task_type::SHRINK ? 0 : 1];
      }
    if (std::string(source) == "chair_spindle") CHECK(unlike[0] + unlike[1] > 0);
    const Measured_blend measured = measured_blend(source, target);
    for (double t : {0.5, 0.75})
      CHECK(measured.gap(t) <= wider);
  }
}

TEST_CASE("Mirror images become mirror images of one another")
{
  const Model& chair = model("chair_four_legged");
  const std::size_t leg = part_named(chair, "front_left_leg"), image = part_named(chair, "front_right_leg");
  REQUIRE(std::max(leg, image) < chair.shape.parts().size());
  Correspondence one_leg;
  one_leg.pairs = {{leg, leg}};
  const Shape_blend blend = blend_of(chair, chair, one_leg);
  const auto& tasks = blend.schedules()[0].tasks;
  CHECK(std::any_of(tasks.begin(), tasks.end(),
                    [&](const Blend_task& task) { return task.source == image && task.target == image; }));
  CHECK(Measured_blend(chair, chair, one_leg).asymmetry(0.5) <= wider);
}

TEST_CASE("A part that touches nothing between the ends is rated as apart")
{
  // A peg on one side moves from the upper plate to the lower one: it touches a plate at both ends only
  const auto stand = [](double height_of_peg) {
    Model result{Segmented_shape("stand"), {}};
    result.shape.add_part("base", box_shapes::box({0, 0.05, 0}, {1, 0.1, 0.6}));
    result.shape.add_part("column", box_shapes::box({0, 0.5, 0}, {0.1, 0.8, 0.1}));
    result.shape.add_part("top", box_shapes::box({0, 0.35, 0}, {1, 0.1, 0.6}));
    result.shape.add_part("peg", box_shapes::box({0.4, height_of_peg, 0}, {0.02, 0.02, 0.02}));
    Structure_options options;
    options.abstraction.abstractor = Bounding_box_abstraction();
    result.graph = build_structural_graph(result.shape, options);
    structure(result.graph).frame.mirror_x = true;
    return result;
  };
  const Model high = stand(0.29), low = stand(0.11);
  Correspondence same;
  same.pairs = {{0, 0}, {1, 1}, {2, 2}, {3, 3}};
  const Shape_blend blend = blend_of(high, low, same);
  for (double t : {0., 1.})
    CHECK(blend.quality(t).apart == 0);
  CHECK(blend.quality(0.5).apart > 0.02);
}

TEST_CASE("Contacts of mirror images are kept alike, though one of them is just too wide to count as touching")
{
  const auto plane = [](double left_gap, double right_gap) {
    Model result{Segmented_shape("plane"), {}};
    result.shape.add_part("body", box_shapes::box({0, 0.6, 0}, {0.2, 0.8, 0.2}));
    result.shape.add_part("left", box_shapes::box({-0.35 - left_gap, 0.6, 0}, {0.5, 0.2, 0.2}));
    result.shape.add_part("right", box_shapes::box({0.35 + right_gap, 0.6, 0}, {0.5, 0.2, 0.2}));
    result.shape.add_part("foot", box_shapes::box({0, 0.1, 0}, {0.6, 0.2, 0.4}));
    Structure_options options;
    options.abstraction.abstractor = Bounding_box_abstraction();
    result.graph = build_structural_graph(result.shape, options);
    structure(result.graph).frame.mirror_x = true;
    return result;
  };
  const double tolerance = Blend_options().contact_tolerance, gap = 1.01 * tolerance;
  const Model source = plane(0, 0), target = plane(0.99 * tolerance, gap);
  Correspondence same;
  same.pairs = {{0, 0}, {1, 1}, {2, 2}, {3, 3}};
  const Shape_blend blend = blend_of(source, target, same);
  for (double t : {0.25, 0.49, 0.75}) {
    INFO("t = " << t);
    const Segmented_shape shape = blend(t);
    const auto& parts = shape.parts();
    const double body = parts[0].mesh.points.row(0).maxCoeff(), wing = parts[2].mesh.points.row(0).minCoeff();
    CHECK(wing - body == Approx(t * gap).margin(0.002));
    CHECK(-parts[1].mesh.points.row(0).maxCoeff() == Approx(wing).margin(0.002));
  }
}

TEST_CASE("Parts on the mirror plane keep contacts on both of its sides, whenever each of them changes")
{
  // A foot between two cheeks, which are one part
  const auto vice = [](double width) {
    Model result{Segmented_shape("vice"), {}};
    const double cheek = width / 2 + 0.05;
    const Part_mesh left = box_shapes::box({-cheek, 0.7, 0}, {0.1, 0.6, 0.2});
    const Part_mesh right = box_shapes::box({cheek, 0.7, 0}, {0.1, 0.6, 0.2});
    Part_mesh cheeks{Points(3, 2 * left.points.cols()), Eigen::Matrix3Xi(3, 2 * left.triangles.cols())};
    cheeks.points << left.points, right.points;
    cheeks.triangles << left.triangles, right.triangles.array() + int(left.points.cols());
    result.shape.add_part("foot", box_shapes::box({0, 0.25, 0}, {width, 0.5, 0.2}));
    result.shape.add_part("cheeks", cheeks);
    Structure_options options;
    options.abstraction.abstractor = Bounding_box_abstraction();
    result.graph = build_structural_graph(result.shape, options);
    structure(result.graph).frame.axes.setIdentity();
    structure(result.graph).frame.mirror_x = true;
    return result;
  };
  const Model wide = vice(0.6), narrow = vice(0.2);
  Correspondence same;
  same.pairs = {{0, 0}, {1, 1}};
  const Measured_blend blend(wide, narrow, same);
  for (double t : {0.25, 0.5, 0.75}) {
    CHECK(blend.gap(t) < 0.015); // the cheeks are stretched together with the foot between them
    CHECK(blend.asymmetry(t) < 0.001);
  }
}

TEST_CASE("Mirror images may be abstracted by a curve and a sheet, and become parts that are no mirror images")
{
  const auto plane = [](Abstraction_kind left, double height) {
    Model result{Segmented_shape("plane"), {}};
    result.shape.add_part("body", box_shapes::box({0, 0.5, 0}, {0.2, 1, 0.2}));
    result.shape.add_part("left", box_shapes::box({-0.35, height, 0}, {0.5, 0.1, 0.2}));
    result.shape.add_part("right", box_shapes::box({0.35, 0.6, 0}, {0.5, 0.1, 0.2}));
    Structure_options options;
    options.abstraction.abstractor = Bounding_box_abstraction();
    options.abstraction.part_kinds = {{"left", left}, {"right", Abstraction_kind::SHEET}};
    result.graph = build_structural_graph(result.shape, options);
    structure(result.graph).frame.axes.setIdentity();
    structure(result.graph).frame.mirror_x = true;
    REQUIRE(structure(result.graph).parts[1].is_sheet() == (left == Abstraction_kind::SHEET));
    return result;
  };
  const Model source = plane(Abstraction_kind::CURVE, 0.6), target = plane(Abstraction_kind::SHEET, 0.3);
  Correspondence same;
  same.pairs = {{0, 0}, {1, 1}, {2, 2}};
  for (const Shape_blend& blend : {blend_of(source, target, same), blend_of(target, source, same)}) {
    const Segmented_shape shape = blend(0.4);
    const Points& right = shape.parts()[2].mesh.points;
    const Point low = right.rowwise().minCoeff(), high = right.rowwise().maxCoeff();
    CHECK(((low + high) / 2 - Point(0.35, 0.6, 0)).norm() < 1e-3);
    CHECK((high - low - Point(0.5, 0.1, 0.2)).norm() < 1e-3);
  }
}

TEST_CASE("Mirror images of round parts and of parts that hang in the middle stay mirror images")
{
  const Measured_blend blend = measured_blend("table_four_legged", "table_pedestal");
  for (double t : {0.3, 0.6}) {
    INFO("t = " << t);
    CHECK(blend.asymmetry(t) <= wider);
    CHECK(blend.gap(t) <= wider);
  }
}

TEST_CASE("Shapes in between are the same whatever the order of parts")
{
  // Largest accepted difference, over the shape's height. It comes from asymmetries: of two mirror images, the one that
  // comes first is computed, and the other one is its image
  constexpr double alike = 0.002;
  const Model &source = model("chair_four_legged"), &target = model("chair_slatted");
  Model reversed{Segmented_shape(source.shape.name(), source.shape.up()), {}};
  const std::size_t count = source.shape.parts().size();
  for (std::size_t i = count; i-- > 0;)
    reversed.shape.add_part(source.shape.parts()[i].name, source.shape.parts()[i].mesh);
  Structure_options options;
  options.abstraction.abstractor = Bounding_box_abstraction();
  reversed.graph = build_structural_graph(reversed.shape, options);
  const Correspondence given = find_correspondence(source.graph, target.graph);
  Correspondence other = given;
  for (auto& pair : other.pairs)
    pair.source = count - 1 - pair.source;
  const Shape_blend blend = blend_of(source, target, given), same = blend_of(reversed, target, other);
  for (double t : {0.2, 0.4, 0.7}) {
    INFO("t = " << t);
    const Segmented_shape shape = blend(t), again = same(t);
    CHECK(shape.parts().size() == again.parts().size());
    for (const Shape_part& part : shape.parts()) {
      INFO(part.name);
      const auto& parts = again.parts();
      const auto found = std::find_if(parts.begin(), parts.end(), [&](const auto& p) { return p.name == part.name; });
      REQUIRE(found != parts.end());
      const auto corner = [](const Points& points) { return Points(points.rowwise().minCoeff()); };
      CHECK((corner(found->mesh.points) - corner(part.mesh.points)).norm() < alike);
    }
  }
}

TEST_CASE("A shape blended with itself stays as it is")
{
  const Model& chair = model("chair_four_legged");
  Correspondence identity;
  for (std::size_t i = 0; i < chair.shape.parts().size(); ++i)
    identity.pairs.push_back({i, i});
  const Shape_blend blend = blend_of(chair, chair, identity);
  for (double t : {0.3, 0.7}) {
    CHECK(hausdorff_distance(blend(t), blend(0)) < 1e-3);
  }
}

TEST_CASE("A shape is the same whatever was asked before, and by whichever thread")
{
  const Shape_blend blend = blend_of("chair_four_legged", "chair_slatted"),
                    same = blend_of("chair_four_legged", "chair_slatted");
  const std::vector<Points> points = same.points(0.4);
  const Blend_quality quality = same.quality(0.6);
  std::vector<Points> first, second;
  std::thread other([&] { first = blend.points(0.4); });
  second = blend.points(0.4);
  other.join();
  CHECK(first == points);
  CHECK(second == points);
  blend(0.6);
  CHECK(blend.quality(0.6).apart == quality.apart);
  CHECK(blend.quality(0.6).support == quality.support);
  for (const Shape_blend& different : blend.different_blends())
    CHECK((different.points(0.4) == points) == (different.schedules()[0].name == blend.schedules()[0].name));
}

TEST_CASE("Nothing jumps: shapes at times near each other are near each other")
{
  const Shape_blend blend = blend_of("chair_four_legged", "chair_slatted");
  for (const Blend_surface& surface : blend.surfaces()) {
    if (surface.begin > 0.01 && surface.begin < 0.99) {
      INFO(surface.name << " from " << surface.begin);
      CHECK(distance(blend(surface.begin - 1e-4), blend(surface.begin + 1e-4)) < 0.05);
    }
  }
}

TEST_CASE("Tasks are those of the correspondence, within the time of the blend")
{
  const Model &source = model("chair_four_legged"), &target = model("chair_slatted");
  const Shape_blend blend = blend_of("chair_four_legged", "chair_slatted");
  REQUIRE(blend.schedules().size() > 1);
  std::vector<int> from(source.shape.parts().size(), 0), to(target.shape.parts().size(), 0);
  for (const Blend_task& task : blend.schedules()[0].tasks) {
    CHECK(task.begin >= 0);
    CHECK(task.begin <= task.end); // equal for an exchange
    CHECK(task.end <= 1);
    if (task.source != Blend_task::no_part) ++from[task.source];
    if (task.target != Blend_task::no_part) ++to[task.target];
    CHECK((task.type == Blend_task_type::SHRINK) == (task.target == Blend_task::no_part));
    CHECK((task.type == Blend_task_type::GROW) == (task.source == Blend_task::no_part));
  }
  CHECK(*std::min_element(from.begin(), from.end()) > 0);
  CHECK(*std::min_element(to.begin(), to.end()) > 0);
}

TEST_CASE("Without a correspondence parts appear and vanish, or become parts similar in place and size")
{
  const Model& stool = model("stool");
  const Shape_blend blend = blend_of(stool, stool, Correspondence());
  for (const Blend_task& task : blend.schedules()[0].tasks)
    CHECK(task.type == Blend_task_type::EXCHANGE);
  const Shape_blend other = blend_of(stool, model("airplane_propeller"), Correspondence());
  for (const Blend_task& task : other.schedules()[0].tasks)
    CHECK((task.source == Blend_task::no_part || task.target == Blend_task::no_part ||
           task.type == Blend_task_type::EXCHANGE));
  CHECK(is_moved(blend(1), stool.shape));
  CHECK(blend(0.25).parts().size() > 0);
}

TEST_CASE("A part without mirror image grows by itself, though others vanish")
{
  const Model& stool = model("stool");
  Model lopsided{stool.shape, {}};
  Part_mesh knob = stool.shape.parts()[0].mesh;
  const Point middle = knob.points.rowwise().mean(), corner = knob.points.rowwise().maxCoeff();
  knob.points = (0.05 * (knob.points.colwise() - middle)).colwise() + corner;
  lopsided.shape.add_part("knob", std::move(knob));
  Structure_options options;
  options.abstraction.abstractor = Bounding_box_abstraction();
  lopsided.graph = build_structural_graph(lopsided.shape, options);
  REQUIRE(structure(lopsided.graph).frame.mirror_x);
  const Shape_blend blend = blend_of(stool, lopsided, Correspondence());
  CHECK(is_moved(blend(1), lopsided.shape));
  CHECK(is_closed(blend(0.75).parts().back().mesh));
}

TEST_CASE("A model that does not belong to its graph is refused")
{
  const Model &stool = model("stool"), &chair = model("chair_spindle");
  CHECK_THROWS_AS(Shape_blend(stool.graph, chair.shape, chair.graph, chair.shape, {}), Invalid_input);
}

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "blend/Blend_stage.h"
#include "blend_checks.h"
#include "box_models.h"

#include <CGAL/Shape_correspondence/IO/read_segmented_shape.h>
#include <CGAL/Shape_correspondence/blend_shapes.h>
#include <CGAL/Shape_correspondence/build_structural_graph.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

// Unmatched parts move with a warp of space; corresponding parts that do not morph move to their counterparts' boxes.

using namespace CGAL::Shape_correspondence;
using namespace blend_checks;
using namespace box_models;

namespace {

Part_mesh bars(const std::vector<Named_box>& boxes)
{
  Part_mesh result;
  for (const Named_box& named : boxes) {
    const Part_mesh bar = box_shapes::box(named.middle, named.size);
    const Eigen::Index points = result.points.cols(), triangles = result.triangles.cols();
    result.points.conservativeResize(3, points + bar.points.cols());
    result.points.rightCols(bar.points.cols()) = bar.points;
    result.triangles.conservativeResize(3, triangles + bar.triangles.cols());
    result.triangles.rightCols(bar.triangles.cols()) = bar.triangles.array() + int(points);
  }
  return result;
}

Box_model with_mesh(const Box_model& model, const std::string& name, const Part_mesh& mesh)
{
  Segmented_shape shape(model.shape.name());
  for (const Shape_part& part : model.shape.parts())
    shape.add_part(part.name, part.name == name ? mesh : part.mesh);
  return model_of(shape);
}

const Part_mesh* mesh_of(const Segmented_shape& shape, const std::string& name)
{
  for (const Shape_part& part : shape.parts())
    if (part.name == name) return &part.mesh;
  return nullptr;
}

/// A stand whose top is three bars with gaps, which a surface from a board would have to bridge.
Box_model grille()
{
  std::vector<Named_box> boxes;
  for (int i = -1; i <= 1; ++i)
    boxes.push_back({"", {0.46 * i, 0.95, 0}, {0.08, 0.1, 0.6}});
  return with_mesh(model_of(stand()), "top", bars(boxes));
}

const Blend_task& task_of(const Shape_blend& blend, std::size_t source)
{
  const auto& tasks = blend.schedules()[0].tasks;
  return *std::find_if(tasks.begin(), tasks.end(), [&](const Blend_task& task) { return task.source == source; });
}

} // namespace

TEST_CASE("Unmatched parts follow the whole shape where all of it changes alike")
{
  // Everything becomes 1.5 times as wide, including the vase and its distance from the middle
  std::vector<Named_box> narrow = stand(), wide = stand();
  for (Named_box& box : wide) {
    box.middle.x() *= 1.5;
    box.size.x() *= 1.5;
  }
  narrow.push_back({"vase", {0.3, 1.1, 0.1}, {0.2, 0.2, 0.2}});
  wide.push_back({"lid", {0, 1.1, 0}, {1.5, 0.2, 0.6}}); // makes both equally high
  const Shape_blend blend = blend_of(model_of(narrow), model_of(wide), same_parts(3));
  const double begin = task_of(blend, 3).begin;
  for (double t : {0.05, 0.15, 0.25}) {
    REQUIRE(t < begin);
    const Segmented_shape shape = blend(t);
    const Part_mesh* vase = mesh_of(shape, "vase~");
    REQUIRE(vase);
    const internal::contacts::Box box = internal::box_of(vase->points);
    const double factor = 1 + t / 2;
    CHECK(box.center().x() == Approx(0.3 * factor).margin(1e-4));
    CHECK(box.sizes().x() == Approx(0.2 * factor).margin(1e-4));
    CHECK(box.sizes().z() == Approx(0.2).margin(1e-4));
  }
}

TEST_CASE("A part that would be torn moves to the box of its counterpart, which replaces it")
{
  std::vector<Named_box> wide = stand();
  for (Named_box& box : wide)
    if (box.name == "top") box.size.x() = 1.6;
  const Box_model board = model_of(wide), bars = grille();
  for (bool forward : {true, false}) {
    const Box_model &source = forward ? board : bars, &target = forward ? bars : board;
    const Shape_blend blend = blend_of(source, target, same_parts(3));
    CHECK(task_of(blend, 0).type == Blend_task_type::MORPH);
    CHECK(task_of(blend, 2).obstacle == Blend_obstacle::TORN);
    const double change = task_of(blend, 2).end;
    for (double t : {0.05, 0.2, 0.6, 0.8, 0.95}) {
      INFO("t " << t << " forward " << forward);
      const Segmented_shape shape = blend(t);
      const Part_mesh *old_top = mesh_of(shape, "top~"), *new_top = mesh_of(shape, "~top");
      REQUIRE((t < change ? old_top : new_top));
      REQUIRE_FALSE((t < change ? new_top : old_top));
      const double width = internal::box_of((t < change ? old_top : new_top)->points).sizes().x();
      const double share = forward ? t : 1 - t;
      CHECK(width == Approx((1 - share) * 1.6 + share * 1).epsilon(0.04));
      CHECK(widest_gap(shape, 1.1) < 0.01);
    }
  }
}

TEST_CASE("The warp between symmetric shapes is symmetric")
{
  // Knobs at both sides are lowered; the unmatched rail is in the middle
  const auto model = [](double knob, bool has_rail) {
    std::vector<Named_box> boxes = stand();
    for (double side : {-1., 1.})
      boxes.push_back({side < 0 ? "left" : "right", {0.4 * side, 1 + knob, 0.1}, {0.1, 0.2, 0.1}});
    boxes.push_back({has_rail ? "rail" : "lid", {0, 1.2, has_rail ? -0.2 : 0.2}, {0.8, 0.4, 0.1}});
    Box_model result = model_of(boxes);
    structure(result.graph).frame.axes.setIdentity();
    structure(result.graph).frame.mirror_x = true;
    return result;
  };
  const Shape_blend blend = blend_of(model(0.3, true), model(0.1, false), same_parts(5));
  const Segmented_shape shape = blend(0.1);
  const Part_mesh* rail = mesh_of(shape, "rail~");
  REQUIRE(rail);
  for (Eigen::Index i = 0; i < rail->points.cols(); ++i) {
    const Point image = internal::mirrored(Point(rail->points.col(i)));
    CHECK((rail->points.colwise() - image).colwise().norm().minCoeff() < 1e-6);
  }
}

TEST_CASE("An unmatched post that touches one part stays straight and nearly upright")
{
  // The top moves to one side; a post stands beside it, and touches only the base
  std::vector<Named_box> from = stand(), to = stand();
  from.push_back({"post", {0.44, 0.4, 0.25}, {0.06, 0.6, 0.06}});
  to[2].middle.x() = 0.3;
  const Shape_blend blend = blend_of(model_of(from), model_of(to), same_parts(3));
  for (double t : {0.05, 0.1}) {
    const Segmented_shape shape = blend(t);
    const Part_mesh* post = mesh_of(shape, "post~");
    REQUIRE(post);
    const internal::contacts::Box box = internal::box_of(post->points);
    CHECK(box.sizes().x() == Approx(0.06).epsilon(0.1));
    CHECK(box.sizes().z() < 0.06 + 0.6 * std::tan(CGAL_PI / 180)); // it leans by less than a degree
  }
}

TEST_CASE("Blends do not depend on units and places")
{
  // Distances between corners of boxes are equal except for rounding errors, which must not decide anything
  std::vector<Named_box> wide = stand(), narrow = stand();
  wide[2].size.x() = 1.6;
  narrow.push_back({"vase", {0.3, 1.1, 0.1}, {0.2, 0.2, 0.2}});
  const Box_model source = model_of(narrow), target = model_of(wide);
  Segmented_shape moved("moved", source.shape.up());
  for (const Shape_part& part : source.shape.parts())
    moved.add_part(part.name, {(39.37 * part.mesh.points).colwise() + Point(12.3, -3.1, 7.7), part.mesh.triangles});
  Blend_options options;
  options.size = Blend_size::SAME;
  const auto blend_from = [&](const Box_model& from) {
    return Shape_blend(from.graph, from.shape, target.graph, target.shape, same_parts(3), options);
  };
  const Shape_blend blend = blend_from(source), other = blend_from(model_of(moved));
  for (double t : {0.1, 0.4, 0.7}) {
    const Segmented_shape shape = blend(t), same = other(t);
    REQUIRE(shape.parts().size() == same.parts().size());
    for (std::size_t i = 0; i < shape.parts().size(); ++i)
      CHECK((shape.parts()[i].mesh.points - same.parts()[i].mesh.points).cwiseAbs().maxCoeff() < 1e-9);
  }
}

TEST_CASE("Flat shapes, whose control points are in one plane, have warps, too")
{
  const std::vector<Named_box> plates = {{"plate", {0, 0.2, 0}, {1, 0, 1}}, {"other", {1, 0.2, 0}, {0.6, 0, 0.6}}};
  for (const Correspondence& correspondence : {same_parts(1), Correspondence()}) {
    const Shape_blend blend = blend_of(model_of(plates), model_of(plates), correspondence);
    for (double t : {0.1, 0.3, 0.6, 0.9})
      for (const Points& points : blend.points(t))
        CHECK((points.allFinite() && points.cwiseAbs().maxCoeff() < 3));
  }
}

TEST_CASE("An unmatched part is exchanged for the part in its place, unless two share that place equally")
{
  const auto with_blocks = [](const std::vector<Named_box>& blocks) {
    std::vector<Named_box> boxes = stand();
    boxes.insert(boxes.end(), blocks.begin(), blocks.end());
    return model_of(boxes);
  };
  const Box_model block = with_blocks({{"block", {0, 1.2, 0}, {0.6, 0.4, 0.4}}});
  const Box_model one = with_blocks({{"jar", {0.02, 1.2, 0}, {0.5, 0.4, 0.4}}});
  const Box_model two =
      with_blocks({{"jar", {-0.02, 1.2, 0.12}, {0.5, 0.4, 0.24}}, {"urn", {0.02, 1.2, -0.12}, {0.5, 0.4, 0.24}}});
  CHECK(task_of(blend_of(block, one, same_parts(3)), 3).type == Blend_task_type::EXCHANGE);
  CHECK(task_of(blend_of(block, two, same_parts(3)), 3).type == Blend_task_type::SHRINK);
}

TEST_CASE("Blends of models stay connected, and main parts become their counterparts")
{
  struct Expected
  {
    std::string from, to;
    std::set<std::string> matched;
  };
  const std::vector<Expected> pairs = {{"chair_spindle", "chair_swivel", {"saddle_seat~cushion_seat"}},
                                       {"chair_four_legged", "chair_swivel", {"seat~cushion_seat"}},
                                       {"bicycle", "tricycle", {"saddle~perch", "fork_crown~yoke"}}};
  for (const auto& [from, to, matched] : pairs) {
    INFO(from << " to " << to);
    std::vector<Segmented_shape> shapes;
    std::vector<Structural_graph> graphs;
    for (const std::string& name : {from, to}) {
      shapes.push_back(IO::read_segmented_shape(SHAPE_CORRESPONDENCE_DATA_DIR "/" + name));
      graphs.push_back(build_structural_graph(shapes.back()));
    }
    const Shape_blend blend(graphs[0], shapes[0], graphs[1], shapes[1], find_correspondence(graphs[0], graphs[1]));
    std::set<std::string> names;
    const Segmented_shape half_way = blend(0.5);
    for (const Shape_part& part : half_way.parts())
      names.insert(part.name);
    CHECK(std::includes(names.begin(), names.end(), matched.begin(), matched.end()));
    // Parts of the bicycle with distant counterparts, such as pedals, come apart
    CHECK(blend.schedules()[0].quality.apart <= (from == "bicycle" ? 0.05 : 0.03));
  }
}

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "blend/Blend_part.h"
#include "blend/Rest_surface.h"
#include "blend_checks.h"
#include "box_models.h"

#include <CGAL/Shape_correspondence/IO/read_segmented_shape.h>
#include <CGAL/Shape_correspondence/IO/write_blend.h>
#include <CGAL/Shape_correspondence/blend_shapes.h>
#include <CGAL/Shape_correspondence/build_structural_graph.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <sstream>
#include <string>
#include <vector>

// Matched parts whose surfaces are exchanged, parts that would come off, and parts that are alike together.

using namespace CGAL::Shape_correspondence;
using namespace blend_checks;
using namespace box_models;
using Catch::Matchers::Contains;

namespace {

/// Boxes side by side as one mesh.
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

/// A model with another mesh for one part.
Box_model with_mesh(const Box_model& model, const std::string& name, const Part_mesh& mesh)
{
  Segmented_shape shape(model.shape.name());
  for (const Shape_part& part : model.shape.parts())
    shape.add_part(part.name, part.name == name ? mesh : part.mesh);
  return model_of(shape);
}

double volume(const Part_mesh& mesh)
{
  const internal::Rest_surface surface(mesh.points, mesh.triangles);
  return surface.extent().volume;
}

const Part_mesh* mesh_of(const Segmented_shape& shape, const std::string& name)
{
  for (const Shape_part& part : shape.parts())
    if (part.name == name) return &part.mesh;
  return nullptr;
}

/// A stand whose top is five bars with gaps, which the surface of a board would have to leave.
Box_model grille()
{
  std::vector<Named_box> boxes;
  for (int i = -2; i <= 2; ++i)
    boxes.push_back({"", {0.22 * i, 0.95, 0}, {0.12, 0.1, 0.6}});
  return with_mesh(model_of(stand()), "top", bars(boxes));
}

const Blend_task& task_of(const Shape_blend& blend, std::size_t source)
{
  const auto& tasks = blend.schedules()[0].tasks;
  return *std::find_if(tasks.begin(), tasks.end(), [&](const Blend_task& task) { return task.source == source; });
}

} // namespace

TEST_CASE("A part whose surface would be torn is stretched with its box, and exchanged for its counterpart")
{
  std::vector<Named_box> wide = stand();
  for (Named_box& box : wide)
    if (box.name == "top") box.size.x() = 1.6;
  const Box_model board = model_of(wide), bars = grille();
  const double board_volume = volume(board.shape.parts()[2].mesh), bars_volume = volume(bars.shape.parts()[2].mesh);
  for (bool forward : {true, false}) {
    const Box_model &source = forward ? board : bars, &target = forward ? bars : board;
    const Shape_blend blend = blend_of(source, target, same_parts(3));
    for (const Blend_task& task : blend.schedules()[0].tasks) {
      CHECK(task.type == Blend_task_type::MORPH);
      CHECK(task.obstacle == Blend_obstacle::NONE);
    }
    for (double t : {0.05, 0.2, 0.44, 0.46, 0.5, 0.8, 0.95}) {
      INFO("t " << t << " forward " << forward);
      const Segmented_shape shape = blend(t);
      const Part_mesh* top = mesh_of(shape, "top~top");
      REQUIRE(top);
      const double width = internal::box_of(top->points).sizes().x(), share = forward ? t : 1 - t;
      CHECK(width == Approx((1 - share) * 1.6 + share * 1).epsilon(0.01));
      const bool is_board = (t < 0.45) == forward;
      CHECK(volume(*top) / width == Approx(is_board ? board_volume / 1.6 : bars_volume / 1).epsilon(0.01));
    }
  }
}

TEST_CASE("What is inside a part that is exchanged comes with it")
{
  std::vector<Named_box> with_drawer = stand();
  with_drawer.push_back({"drawer", {0.1, 0.95, 0.1}, {0.3, 0.06, 0.3}});
  Box_model target = model_of(with_drawer);
  target = with_mesh(target, "top", *mesh_of(grille().shape, "top"));
  const Shape_blend blend = blend_of(model_of(stand()), target, same_parts(3));
  CHECK(mesh_of(blend(0.44), "~drawer") == nullptr);
  CHECK(mesh_of(blend(0.46), "~drawer") != nullptr);
}

TEST_CASE("Of two parts that touch, the smaller one is moved to the larger one where the gap would open")
{
  // Bars, of which one is low, become a block with a step: what is on the low one would hover above bars that shrink
  std::vector<Named_box> low;
  for (int i = -2; i <= 2; ++i) {
    const double height = i < 2 ? 0.8 : 0.3;
    low.push_back({"", {0.3 * i, height / 2, 0}, {0.16, height, 0.8}});
  }
  const std::vector<Named_box> step = {{"", {-0.15, 0.35, 0}, {1.06, 0.7, 0.8}}, {"", {0.53, 0.2, 0}, {0.3, 0.4, 0.8}}};
  const auto model = [](const std::vector<Named_box>& block, double knob) {
    const std::vector<Named_box> boxes = {{"block", {0, 0, 0}, {1, 1, 1}}, {"knob", {0.6, knob, 0}, {0.1, 0.1, 0.1}}};
    Box_model result = with_mesh(model_of(boxes), "block", bars(block));
    structure(result.graph).frame.axes.setIdentity();
    return result;
  };
  const Shape_blend blend = blend_of(model(low, 0.35), model(step, 0.45), same_parts(2));
  for (const Blend_task& task : blend.schedules()[0].tasks)
    CHECK(task.type == Blend_task_type::MORPH);
  for (double t = 0.05; t < 1; t += 0.05) {
    INFO("t " << t);
    const std::vector<Triangle_tree> trees = trees_of(blend(t));
    REQUIRE(trees.size() == 2);
    CHECK(std::sqrt(trees[0].nearly_closest(trees[1]).squared) < 0.005);
    CHECK(trees[1].box().center().x() > 0.3); // on its half
  }
}

TEST_CASE("A part that would come off what it touches does not morph: a crest stays on its posts")
{
  // The posts that carry it become short ones, while a column carries the crest of the target
  const auto chair = [](double posts) {
    std::vector<Named_box> result = {{"seat", {0, 0.5, 0}, {1, 0.1, 1}},
                                     {"left", {-0.45, 0.55 + posts / 2, -0.45}, {0.1, posts, 0.1}},
                                     {"right", {0.45, 0.55 + posts / 2, -0.45}, {0.1, posts, 0.1}},
                                     {"crest", {0, 1.1, -0.45}, {1, 0.1, 0.1}}};
    if (posts < 0.5) result.push_back({"column", {0, 0.8, -0.45}, {0.1, 0.5, 0.1}});
    return model_of(result);
  };
  const Box_model source = chair(0.5), target = chair(0.2);
  const Shape_blend blend = blend_of(source, target, same_parts(4));
  CHECK(task_of(blend, 0).type == Blend_task_type::MORPH);
  const auto& tasks = blend.schedules()[0].tasks;
  CHECK(std::any_of(tasks.begin(), tasks.end(),
                    [](const Blend_task& task) { return task.obstacle == Blend_obstacle::APART; }));
  std::ostringstream json;
  IO::write_blend_json(json, blend, source.graph, target.graph, "a", "b", "c", 2, {});
  CHECK_THAT(json.str(), Contains("\"obstacle\":\"apart\""));
  for (double t = 0.05; t < 1; t += 0.05) {
    INFO("t " << t);
    CHECK(widest_gap(blend(t), 1.15) < 0.03);
  }
}

TEST_CASE("Parts that are alike together merge, also where they go farther than pieces may")
{
  // The halves of a high seat become a low one
  const auto stool = [](double height, const std::vector<Named_box>& seats) {
    std::vector<Named_box> result = {{"foot", {0, 0.05, 0}, {1, 0.1, 1}}};
    result.insert(result.end(), seats.begin(), seats.end());
    if (height < 1) result.push_back({"back", {0, 0.55, -0.45}, {1, 0.9, 0.1}});
    return model_of(result);
  };
  const auto halves = [](double width) -> std::vector<Named_box> {
    return {{"left", {-width / 2, 0.95, 0}, {width, 0.1, 0.8}}, {"right", {width / 2, 0.95, 0}, {width, 0.1, 0.8}}};
  };
  const Box_model low = stool(0.5, {{"seat", {0, 0.45, 0}, {1, 0.1, 0.8}}});
  Correspondence correspondence = same_parts(1);
  correspondence.pairs.push_back({1, 1});
  correspondence.pairs.push_back({2, 1});
  const Shape_blend merged = blend_of(stool(1, halves(0.5)), low, correspondence);
  CHECK(task_of(merged, 1).type == Blend_task_type::MERGE);
  CHECK(task_of(merged, 2).type == Blend_task_type::MERGE);
  const Shape_blend apart = blend_of(stool(1, halves(0.06)), low, correspondence); // together, they are a bar
  CHECK(task_of(apart, 1).obstacle == Blend_obstacle::UNLIKE);
}

TEST_CASE("Blends of models hang together, and main parts become their counterparts")
{
  struct Expected
  {
    std::string from, to;
    std::set<std::string> matched;
  };
  const std::vector<Expected> pairs = {
      {"airplane_propeller", "airplane_twin_engine", {"body~hull", "wing_a~port_wing", "wing_b~starboard_wing"}},
      {"airplane_twin_engine", "airplane_propeller", {"hull~body", "port_wing~wing_a", "starboard_wing~wing_b"}},
      {"chair_spindle", "chair_swivel", {"saddle_seat~cushion_seat", "bow~cushion_back"}},
      {"chair_four_legged", "chair_swivel", {"seat~cushion_seat"}},
      {"bicycle", "tricycle", {"handlebar~bars"}}};
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
    CHECK(blend.schedules()[0].quality.apart < 0.1);
    CHECK(blend.schedules()[0].quality.gap < 0.05);
  }
}

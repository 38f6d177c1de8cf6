// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "blend/Blend_part.h"
#include "blend/schedules.h"
#include "box_models.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

// Which parts of a blend are exchanged, and in which of two steps.

using namespace CGAL::Shape_correspondence;
using namespace box_models;

namespace {

using internal::Exchange_step;

Box_model upright(const std::vector<Named_box>& boxes)
{
  Box_model result = model_of(boxes);
  structure(result.graph).frame.axes.setIdentity();
  return result;
}

/// The step in which each part is exchanged, by its name: `name~` for an old part, `~name` for a new one.
std::map<std::string, Exchange_step> steps(const std::vector<Named_box>& from, const std::vector<Named_box>& to,
                                           const Correspondence& correspondence)
{
  const Box_model source = upright(from), target = upright(to);
  const std::array<internal::Blend_input, 2> inputs = {internal::Blend_input{source.graph, source.shape, 0},
                                                       internal::Blend_input{target.graph, target.shape, 0}};
  const internal::Blend_structure blend(inputs, correspondence, {});
  const std::vector<internal::Exchange> found = internal::exchange_steps(blend, [](double) { return true; });
  std::map<std::string, Exchange_step> result;
  for (std::size_t i = 0; i < found.size(); ++i)
    result[blend.parts[i].name] = found[i].step;
  return result;
}

const Named_box board = {"board", {0, 0.6, 0}, {1.2, 0.08, 0.8}};

std::vector<Named_box> on_walls()
{
  return {board,
          {"left", {-0.5, 0.28, 0}, {0.06, 0.56, 0.7}},
          {"right", {0.5, 0.28, 0}, {0.06, 0.56, 0.7}},
          {"box", {0, 0.82, 0}, {0.9, 0.36, 0.6}}};
}

/// The board of `on_walls()` on a column, with a needle on it.
std::vector<Named_box> on_column()
{
  return {board, {"column", {0, 0.28, 0}, {0.15, 0.56, 0.15}}, {"needle", {0, 0.82, 0}, {0.05, 0.36, 0.05}}};
}

} // namespace

TEST_CASE("Parts below and parts above a part that stays are exchanged in two steps, each at one time")
{
  auto found = steps(on_walls(), on_column(), same_parts(1));
  CHECK(found.at("board~board") == Exchange_step::NONE);
  CHECK(found.at("left~") != Exchange_step::NONE);
  CHECK(found.at("left~") == found.at("right~"));
  CHECK(found.at("left~") == found.at("~column"));
  CHECK(found.at("box~") != Exchange_step::NONE);
  CHECK(found.at("box~") == found.at("~needle"));
  CHECK(found.at("box~") != found.at("left~"));
}

TEST_CASE("The exchanged parts of a symmetry group change in one step")
{
  // Three blocks above each other, between two boards that stay, become walls.
  const auto rack = [](const std::string& name, double x, const Point& size) {
    std::vector<Named_box> result = {{"low board", {0, 0.31, 0}, {1.2, 0.1, 0.8}},
                                     {"high board", {0, 0.67, 0}, {1.2, 0.1, 0.8}}};
    for (double y : {0.13, 0.49, 0.85})
      result.push_back({name + std::to_string(result.size()), {x, y, 0}, size});
    return result;
  };
  auto found = steps(rack("block", 0, {0.2, 0.26, 0.2}), rack("wall", 0.5, {0.06, 0.26, 0.7}), same_parts(5));
  CHECK(found.at("block2~") != Exchange_step::NONE);
  CHECK(found.at("block3~") == found.at("block2~"));
  CHECK(found.at("block4~") == found.at("block2~"));
}

TEST_CASE("Exchanges have two times, or one if that is asked for")
{
  const Box_model source = upright(on_walls()), target = upright(on_column());
  Blend_options options;
  const auto ends = [&](const std::string& schedule) {
    options.schedule = schedule;
    const Shape_blend blend = blend_of(source, target, same_parts(1), options);
    std::map<double, int> result;
    for (const Blend_task& task : blend.schedules()[0].tasks)
      if (task.type != Blend_task_type::MORPH) ++result[task.begin];
    return result;
  };
  const std::map<double, int> two = ends("in two steps"), one = ends("at one time");
  REQUIRE(two.size() == 2);
  CHECK(two.begin()->first < internal::Part_morph::change);
  CHECK(two.rbegin()->first > internal::Part_morph::change);
  CHECK((two.begin()->second == 3 || two.rbegin()->second == 3)); // two walls and a column
  CHECK(one == std::map<double, int>{{internal::Part_morph::change, 5}});
  CHECK(ends("") == two);
}

TEST_CASE("The search for steps and the rating report progress, and end when cancelled")
{
  std::vector<double> told;
  Blend_options options;
  std::size_t most = 100;
  options.progress = [&](double done) {
    told.push_back(done);
    return told.size() < most;
  };
  const Box_model source = upright(on_walls()), target = upright(on_column());
  const Shape_blend blend = blend_of(source, target, same_parts(1), options);
  CHECK(told.size() > 4);
  CHECK(std::is_sorted(told.begin(), told.end()));
  CHECK((told.front() >= 0 && told.front() < 0.1 && told.back() > 0.6 && told.back() <= 1));
  CHECK(blend.different_blends().size() == 2);
  most = 1;
  told.clear();
  const Shape_blend ended = blend_of(source, target, same_parts(1), options);
  CHECK(told.size() == 1);
  CHECK(ended.schedules()[0].name == "in two steps");
  CHECK(ended.schedules()[0].quality.support == 0);
  CHECK(ended.different_blends().size() == 1); // no steps were found, so all schedules give the same blend
}

TEST_CASE("Exchanges take one step if most of the parts on the ground would be missing between two steps")
{
  std::vector<Named_box> on_feet = {board, on_walls().back()};
  for (int i = 0; i < 8; ++i)
    on_feet.push_back(
        {"foot_" + std::to_string(i), {0.3 * (i / 2) - 0.45, 0.28, 0.5 * (i % 2) - 0.25}, {0.1, 0.56, 0.1}});
  const Shape_blend blend = blend_of(upright(on_feet), upright(on_column()), same_parts(1));
  CHECK(blend.schedules()[0].name == "at one time");
  CHECK(blend.schedules()[1].quality.support > 0.6);
}

TEST_CASE("A part that would lose its support is exchanged together with it")
{
  // A bar on two rods that become one: if the rods changed first, one end of the bar would have no support.
  const Named_box base = {"base", {0, 0.05, 0}, {1.4, 0.1, 0.6}}, wall = {"wall", {0.6, 0.5, 0}, {0.1, 0.8, 0.5}};
  const std::vector<Named_box> from = {base,
                                       wall,
                                       {"rod", {-0.4, 0.35, 0}, {0.3, 0.5, 0.3}},
                                       {"other", {0.5, 0.35, 0}, {0.1, 0.5, 0.12}},
                                       {"bar", {0.0, 0.65, 0}, {1.0, 0.1, 0.3}}};
  const std::vector<Named_box> to = {base,
                                     wall,
                                     {"pin", {-0.4, 0.35, 0}, {0.03, 0.5, 0.03}},
                                     {"sail", {-0.53, 0.78, 0}, {0.2, 0.36, 0.5}},
                                     {"jib", {-0.27, 0.78, 0}, {0.2, 0.36, 0.5}}};
  Correspondence correspondence = same_parts(2);
  correspondence.pairs.insert(correspondence.pairs.end(), {{2, 2}, {3, 2}, {4, 3}, {4, 4}});
  auto found = steps(from, to, correspondence);
  CHECK(found.at("rod~") == found.at("other~"));
  CHECK(found.at("bar~") != Exchange_step::NONE);
  CHECK(found.at("bar~") == found.at("rod~"));
}

TEST_CASE("Large parts on a small one are not left hanging in the air")
{
  // A panel on a hook on a pole is exchanged for a sign on a link on a pin, which is far from there.
  const Named_box base = {"base", {0, 0.05, 0}, {2.4, 0.1, 0.6}}, wall = {"wall", {1.1, 0.5, 0}, {0.1, 0.96, 0.5}};
  const std::vector<Named_box> from = {base,
                                       wall,
                                       {"pole", {-0.9, 0.4, 0}, {0.3, 0.6, 0.3}},
                                       {"hook", {-0.9, 0.74, 0}, {0.04, 0.08, 0.04}},
                                       {"panel", {-0.9, 0.88, 0}, {0.5, 0.2, 0.5}}};
  const std::vector<Named_box> to = {base,
                                     wall,
                                     {"pin", {-0.1, 0.125, 0}, {0.05, 0.05, 0.05}},
                                     {"link", {-0.1, 0.19, 0}, {0.005, 0.08, 0.04}},
                                     {"sign", {-0.1, 0.33, 0}, {0.02, 0.2, 0.8}}};
  auto found = steps(from, to, same_parts(5));
  CHECK(found.at("panel~") != Exchange_step::NONE);
  CHECK(found.at("panel~") == found.at("pole~"));
  CHECK(found.at("~sign") == found.at("~pin"));
}

TEST_CASE("Old and new parts are never in one place at once, though different parts support them")
{
  std::vector<Named_box> from = {{"shelf", {0, 0.1, 0}, {1.2, 0.2, 0.8}},
                                 {"back", {-0.55, 0.5, 0}, {0.1, 0.6, 0.8}},
                                 {"top", {0, 0.85, 0}, {1.2, 0.1, 0.8}}},
                         to = from;
  from.push_back({"lamp", {0.35, 0.54, 0}, {0.2, 0.52, 0.2}}); // hangs from the top
  to.push_back({"vase", {0.43, 0.46, 0}, {0.04, 0.52, 0.04}}); // stands on the shelf
  auto found = steps(from, to, same_parts(3));
  CHECK(found.at("lamp~") != Exchange_step::NONE);
  CHECK(found.at("lamp~") == found.at("~vase"));
}

TEST_CASE("A part that would be hidden inside a new one is not kept")
{
  // The old bar goes through the new block, but is in few of the cells that the surface of the block occupies.
  std::vector<Named_box> from = {{"shelf", {0, 0.1, 0}, {2, 0.2, 0.8}},
                                 {"back", {-0.95, 0.5, 0}, {0.1, 0.6, 0.8}},
                                 {"top", {0, 0.85, 0}, {2, 0.1, 0.8}}},
                         to = from;
  from.push_back({"bar", {-0.35, 0.5, 0}, {1.1, 0.04, 0.04}}); // attached to the back
  to.push_back({"block", {-0.2, 0.4, 0}, {1.0, 0.4, 0.6}});    // stands on the shelf
  auto found = steps(from, to, same_parts(3));
  CHECK(found.at("bar~") != Exchange_step::NONE);
  CHECK(found.at("bar~") == found.at("~block"));
}

TEST_CASE("Space that both shapes fill is not empty between the steps")
{
  // An old bar ends where a new one begins, and a third of each is in the same place; each has its counterpart
  // elsewhere. If the old bar, whose group is lower, changed first, there would be a hole between them.
  const Named_box back = {"back", {0, 0.5, -0.3}, {2.4, 1, 0.1}};
  const std::vector<Named_box> from = {
      back, {"left bar", {-0.4, 0.5, -0.2}, {1.2, 0.08, 0.1}}, {"high", {-0.9, 0.85, -0.2}, {0.3, 0.2, 0.1}}};
  const std::vector<Named_box> to = {
      back, {"low", {0.9, 0.2, -0.2}, {0.3, 0.2, 0.1}}, {"right bar", {0.4, 0.5, -0.2}, {1.2, 0.08, 0.1}}};
  auto found = steps(from, to, same_parts(3));
  CHECK(found.at("left bar~") == Exchange_step::SECOND);
  CHECK(found.at("~low") == Exchange_step::SECOND);
  CHECK(found.at("~right bar") == Exchange_step::FIRST);
}

TEST_CASE("A part supported at the same place as an earlier one replaces it")
{
  const std::vector<Named_box> pot = {{"pot", {0, 0.2, 0}, {0.6, 0.4, 0.6}},
                                      {"post", {0, 0.6, -0.25}, {0.1, 0.4, 0.1}}};
  std::vector<Named_box> from = pot, to = pot;
  from.push_back({"cactus", {-0.05, 0.55, 0.1}, {0.2, 0.3, 0.2}});
  to.push_back({"leaf", {0.11, 0.7, 0.1}, {0.02, 0.6, 0.1}}); // beside the cactus
  auto found = steps(from, to, same_parts(2));
  CHECK(found.at("cactus~") != Exchange_step::NONE);
  CHECK(found.at("cactus~") == found.at("~leaf"));
}

TEST_CASE("A part that replaces no other appears and vanishes by itself")
{
  std::vector<Named_box> with_knob = on_walls();
  with_knob.push_back({"knob", {0.62, 0.6, 0}, {0.04, 0.05, 0.05}});
  auto found = steps(on_walls(), with_knob, same_parts(4));
  CHECK(found.at("~knob") == Exchange_step::NONE);
}

TEST_CASE("An old part whose mirror image stays vanishes before new parts appear")
{
  std::vector<Named_box> boxes = {{"base", {0, 0.5, 0}, {1, 1, 0.8}}, {"left knob", {-0.55, 0.5, 0}, {0.1, 0.1, 0.1}}};
  Box_model target = upright(boxes);
  boxes.push_back({"right knob", {0.55, 0.5, 0}, {0.1, 0.1, 0.1}});
  Box_model source = upright(boxes);
  for (Box_model* model : {&source, &target}) {
    structure(model->graph).frame.mirror_x = true;
    structure(model->graph).frame.origin.x() = 0;
  }
  const Shape_blend blend = blend_of(source, target, same_parts(2));
  const std::vector<Blend_task>& tasks = blend.schedules()[0].tasks;
  REQUIRE(tasks.size() == 3);
  CHECK(tasks[1].type == Blend_task_type::MORPH);
  CHECK(tasks[2].type == Blend_task_type::SHRINK);
  CHECK(tasks[2].end < 0.5);
}

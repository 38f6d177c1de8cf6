// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "box_models.h"

#include <CGAL/Shape_correspondence/Blend_schedule.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

// Kinds of tasks, and the times at which parts appear, vanish and replace others.

using namespace CGAL::Shape_correspondence;
using namespace box_models;

namespace {

/// A board on walls or columns, a lamp that hangs from it, and a box on it.
Box_model shelf(double width_of_supports, double width)
{
  return model_of({{"board", {0, 0.6, 0}, {1.6, 0.08, 0.8}},
                   {"left support", {-0.6, 0.28, 0}, {0.05, 0.56, width_of_supports}},
                   {"right support", {0.6, 0.28, 0}, {0.05, 0.56, width_of_supports}},
                   {"lamp", {0, 0.46, 0}, {width, 0.2, 0.05}},
                   {"box", {0, 0.8, 0}, {width, 0.32, width}}});
}

/// Begin and end of the tasks of a type at each place: 's' where the supports are, 'l' the lamp, 'b' the box.
std::map<char, std::pair<double, double>> times(const Shape_blend& blend, const Box_model& model, Blend_task_type type)
{
  std::map<char, std::pair<double, double>> result;
  for (const Blend_task& task : blend.schedules()[0].tasks) {
    if (task.type != type) continue;
    const std::string& name = model.shape.parts()[type == Blend_task_type::GROW ? task.target : task.source].name;
    const std::pair when(task.begin, task.end);
    const char place = name.find("support") == std::string::npos ? name[0] : 's';
    const auto [known, is_new] = result.emplace(place, when);
    CHECK(known->second == when); // both supports are exchanged at one time
  }
  return result;
}

} // namespace

TEST_CASE("A task without times and parts is a morph over the whole time between no parts")
{
  const Blend_task task;
  CHECK(task.type == Blend_task_type::MORPH);
  CHECK(task.obstacle == Blend_obstacle::NONE);
  CHECK((task.source == Blend_task::no_part && task.target == Blend_task::no_part));
  CHECK((task.begin == 0 && task.end == 1));
  const Blend_schedule schedule;
  CHECK((schedule.tasks.empty() && schedule.quality.support == 0 && schedule.quality.apart == 0));
}

TEST_CASE("Parts are exchanged one place after another, and new parts appear at the instant at which old ones vanish")
{
  const Box_model source = shelf(0.7, 0.9), target = shelf(0.05, 0.06);
  const Shape_blend blend = blend_of(source, target, same_parts(1));
  const auto go = times(blend, source, Blend_task_type::SHRINK), come = times(blend, target, Blend_task_type::GROW);
  REQUIRE(go.size() == 3);
  REQUIRE(come.size() == 3);
  std::set<double> instants;
  for (const auto& [place, when] : go) {
    INFO(place);
    CHECK(when.first == when.second);
    CHECK(when == come.at(place));
    instants.insert(when.first);
  }
  CHECK((*instants.begin() >= 0.3 && *instants.rbegin() <= 0.7));
  CHECK(*instants.rbegin() - *instants.begin() > 0.1);
  for (double t : {*instants.begin() - 1e-9, *instants.begin()}) // every part is whole before and after
    CHECK(blend(t).parts().size() == 5);
}

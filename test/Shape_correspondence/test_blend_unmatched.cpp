// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "blend/Blend_structure.h"
#include "blend_checks.h"
#include "box_shapes.h"

#include <CGAL/Shape_correspondence/IO/read_segmented_shape.h>
#include <CGAL/Shape_correspondence/blend_shapes.h>
#include <CGAL/Shape_correspondence/build_structural_graph.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

// Parts without counterpart, and parts that touch in the source or in the target only.

using namespace CGAL::Shape_correspondence;
using namespace blend_checks;
using box_shapes::box;

namespace {

struct Model
{
  explicit Model(Segmented_shape given) : shape(std::move(given)), graph(build_structural_graph(shape)) {}

  std::size_t part(const std::string& name) const
  {
    const auto& parts = shape.parts();
    return std::size_t(std::find_if(parts.begin(), parts.end(), [&](const auto& p) { return p.name == name; }) -
                       parts.begin());
  }

  Segmented_shape shape;
  Structural_graph graph;
};

using Name_pairs = std::vector<std::pair<std::string, std::string>>;

Shape_blend blend_of(const Model& source, const Model& target, const Name_pairs& names)
{
  Correspondence correspondence;
  for (const auto& [from, to] : names)
    correspondence.pairs.push_back({source.part(from), target.part(to)});
  Blend_options options;
  options.samples = 1;
  return Shape_blend(source.graph, source.shape, target.graph, target.shape, correspondence, options);
}

/// The distance between the parts whose names start with `first` and `second`, divided by the height of the shape.
double distance(const Segmented_shape& shape, const std::string& first, const std::string& second)
{
  const std::vector<Triangle_tree> trees = trees_of(shape);
  std::array<std::size_t, 2> found{};
  double low = 1e9, high = -1e9;
  for (std::size_t i = 0; i < trees.size(); ++i) {
    const std::string& name = shape.parts()[i].name;
    if (name.rfind(first, 0) == 0) found[0] = i;
    if (name.rfind(second, 0) == 0) found[1] = i;
    low = std::min(low, trees[i].box().min().y());
    high = std::max(high, trees[i].box().max().y());
  }
  REQUIRE(found[0] != found[1]);
  return std::sqrt(trees[found[0]].nearly_closest(trees[found[1]]).squared) / (high - low);
}

constexpr double touching = 0.02; // gap, over the shape's height, below which parts touch

/// Two posts on a base.
Segmented_shape two_posts(const std::string& name)
{
  Segmented_shape result(name);
  result.add_part("base", box({0, 0.1, 0}, {1, 0.2, 0.5}));
  result.add_part("left", box({-0.4, 0.6, 0}, {0.1, 0.8, 0.1}));
  result.add_part("right", box({0.4, 0.6, 0}, {0.1, 0.8, 0.1}));
  return result;
}

} // namespace

TEST_CASE("A chain of parts vanishes from its middle: all are attached to what carries them until then")
{
  Segmented_shape joined("joined"), apart("apart");
  joined.add_part("foot", box({0, 0.1, 0}, {1, 0.2, 1}));
  joined.add_part("rod", box({0.3, 0.5, 0.1}, {0.06, 0.6, 0.06}));
  joined.add_part("elbow", box({0.25, 0.9, 0.1}, {0.25, 0.2, 0.2}));
  joined.add_part("arm", box({-0.075, 0.9, 0.1}, {0.4, 0.06, 0.06}));
  joined.add_part("shade", box({-0.4, 0.9, 0.1}, {0.25, 0.4, 0.4}));
  apart.add_part("foot", box({0, 0.1, 0}, {1, 0.2, 1}));
  apart.add_part("shade", box({-0.4, 0.9, 0.1}, {0.25, 0.4, 0.4}));
  Model source(joined), target(apart);
  for (Model* model : {&source, &target})
    structure(model->graph).frame.axes.setIdentity();
  const Shape_blend blend = blend_of(source, target, {{"foot", "foot"}, {"shade", "shade"}});
  for (const Blend_task& task : blend.schedules()[0].tasks)
    if (task.type == Blend_task_type::SHRINK) CHECK((task.begin > 0 && task.end - task.begin < 0.2 && task.end < 0.4));
  for (double t = 0.01; t < 0.4; t += 0.01) {
    INFO("t = " << t);
    const Segmented_shape shape = blend(t);
    const auto are_attached = [&](const std::string& part, const std::string& carrier) {
      const auto is_there = [&](const Shape_part& other) { return other.name == part; };
      if (std::none_of(shape.parts().begin(), shape.parts().end(), is_there)) return true;
      return distance(shape, part, carrier) < touching;
    };
    CHECK(are_attached("rod~", "foot~"));
    CHECK(are_attached("elbow~", "rod~"));
    CHECK(are_attached("arm~", "shade~"));
  }
}

TEST_CASE("Unmatched parts that touch each other stay connected")
{
  Segmented_shape plain("plain"), with_bar("with bar");
  for (Segmented_shape* shape : {&plain, &with_bar}) {
    shape->add_part("base", box({0, 0.3, 0}, {1, 0.6, 0.5}));
    shape->add_part("lid", box({0, 0.7, 0}, {1, 0.2, 0.5}));
  }
  with_bar.add_part("knob", box({0, 0.85, 0}, {0.1, 0.1, 0.1}));
  with_bar.add_part("bar", box({0, 0.95, 0}, {0.8, 0.1, 0.1}));
  const Model source(plain), target(with_bar);
  const Shape_blend blend = blend_of(source, target, {{"base", "base"}, {"lid", "lid"}});
  int seen = 0;
  for (double t = 0.3; t < 1; t += 0.1) {
    const Segmented_shape shape = blend(t);
    if (shape.parts().size() < 4) continue;
    ++seen;
    INFO("t = " << t);
    CHECK(distance(shape, "~knob", "~bar") < touching);
  }
  CHECK(seen > 1);
}

TEST_CASE("An unmatched part moves with the place that it touches")
{
  const auto stand = [](double beam) {
    Segmented_shape result("stand");
    result.add_part("base", box({0, 0.1, 0}, {1.6, 0.2, 0.6}));
    result.add_part("mast", box({-0.7, 0.6, 0}, {0.1, 0.8, 0.4})); // clearly asymmetric from side to side
    result.add_part("beam", box({beam, 0.5, 0}, {0.8, 0.6, 0.3}));
    return result;
  };
  constexpr double way = 0.2, knob = 0.35;
  Segmented_shape with_knob = stand(0);
  with_knob.add_part("knob", box({knob, 0.85, 0}, {0.1, 0.1, 0.1}));
  const Model source(with_knob), target(stand(way));
  const Shape_blend blend = blend_of(source, target, {{"base", "base"}, {"mast", "mast"}, {"beam", "beam"}});
  for (double t : {0.05, 0.1, 0.15}) {
    const Segmented_shape shape = blend(t);
    CHECK(shape.parts().back().name == "knob~");
    CHECK(shape.parts().back().mesh.points.row(0).mean() == Approx(knob + t * way).margin(0.002));
  }
}

TEST_CASE("Unmatched parts shrink to where they are held")
{
  const Segmented_shape plain = two_posts("plain");
  Segmented_shape full = two_posts("full");
  full.add_part("rail", box({0, 0.7, 0}, {0.7, 0.06, 0.06}));
  full.add_part("vase", box({0, 0.35, 0}, {0.1, 0.3, 0.1}));
  const Model source(full), target(plain);
  Correspondence same;
  for (std::size_t i = 0; i < 3; ++i)
    same.pairs.push_back({i, i});
  const internal::Blend_structure blend(
      {internal::Blend_input{source.graph, source.shape, 0}, internal::Blend_input{target.graph, target.shape, 0}},
      same, {});
  REQUIRE(blend.parts.size() == 5);
  constexpr double share = 0.4;
  for (std::size_t i : {3u, 4u}) {
    const internal::Blend_part& part = blend.parts[i];
    REQUIRE(!part.is_matched());
    const Points less = blend.growths[i]->points(share), none = blend.growths[i]->points(0);
    const internal::contacts::Box whole = internal::box_of(part.mesh.points), box = internal::box_of(less);
    if (part.name == "rail~") { // attached at both ends: it becomes thin
      CHECK(box.sizes().x() == Approx(whole.sizes().x()).epsilon(0.02));
      CHECK(box.sizes().tail<2>().isApprox(share * whole.sizes().tail<2>(), 1e-6));
      CHECK(internal::box_of(none).sizes().tail<2>().norm() < 1e-9);
    } else {
      CHECK(box.sizes().isApprox(share * whole.sizes(), 1e-6));
      CHECK(box.min().y() == Approx(whole.min().y()).margin(touching));
      CHECK(internal::box_of(none).sizes().norm() < 1e-9);
    }
    CHECK(blend.growths[i]->points(1) == part.mesh.points);
  }
}

TEST_CASE("What grows is attached to what carries it at any time")
{
  const Segmented_shape plain = two_posts("plain");
  Segmented_shape full = two_posts("full");
  full.add_part("rail", box({0, 0.7, 0}, {0.7, 0.06, 0.06}));
  full.add_part("hook", box({0.1, 0.64, 0}, {0.04, 0.06, 0.04})); // hangs on the rail
  const Model source(plain), target(full);
  const Shape_blend blend = blend_of(source, target, {{"base", "base"}, {"left", "left"}, {"right", "right"}});
  const std::vector<Blend_task>& tasks = blend.schedules()[0].tasks;
  REQUIRE(tasks.size() == 5);
  CHECK(tasks[4].begin >= tasks[3].end); // the rail carries the hook
  for (double t = tasks[3].begin + 0.005; t < 1; t += 0.02) {
    INFO("t = " << t);
    const Segmented_shape shape = blend(t);
    CHECK(distance(shape, "~rail", "left~") < touching);
    CHECK(distance(shape, "~rail", "right~") < touching);
    if (shape.parts().size() == 5) CHECK(distance(shape, "~hook", "~rail") < touching);
  }
}

TEST_CASE("Legs stay attached to a seat that becomes far higher")
{
  Segmented_shape high("high"), low("low");
  high.add_part("seat", box({0, 0.65, 0}, {0.9, 0.1, 0.9}));
  high.add_part("column", box({0, 0.3, 0}, {0.1, 0.6, 0.1}));
  high.add_part("back", box({0, 0.85, -0.4}, {0.9, 0.3, 0.1}));
  low.add_part("seat", box({0, 0.4, 0}, {1, 0.1, 1}));
  low.add_part("back", box({0, 0.725, -0.45}, {1, 0.55, 0.1}));
  for (int i : {-1, 1})
    for (int j : {-1, 1})
      low.add_part("leg_" + std::to_string(i) + std::to_string(j), box({0.4 * i, 0.175, 0.4 * j}, {0.06, 0.35, 0.06}));
  const Model source(high), target(low);
  const Shape_blend blend = blend_of(source, target, {{"seat", "seat"}});
  int seen = 0;
  for (double t = 0.1; t < 1; t += 0.1) {
    const Segmented_shape shape = blend(t);
    const auto& parts = shape.parts();
    if (std::none_of(parts.begin(), parts.end(), [](const auto& p) { return p.name == "~leg_11"; })) continue;
    ++seen;
    INFO("t = " << t);
    CHECK(distance(shape, "seat~seat", "~leg_11") < touching);
    for (const Shape_part& part : parts)
      if (part.name == "~leg_11") CHECK(part.mesh.points.row(1).minCoeff() < touching);
  }
  CHECK(seen > 2);
}

TEST_CASE("Parts in one place are exchanged at one time, and so are parts needed to stand")
{
  Segmented_shape legged("legged"), pedestal("pedestal");
  for (Segmented_shape* shape : {&legged, &pedestal})
    shape->add_part("top", box({0, 0.95, 0}, {1, 0.1, 1}));
  for (double x : {-0.4, 0.4})
    legged.add_part(x < 0 ? "left" : "right", box({x, 0.45, 0}, {0.1, 0.9, 0.8}));
  pedestal.add_part("column", box({0, 0.45, 0}, {0.1, 0.9, 0.1}));
  legged.add_part("vase", box({0, 1.15, 0}, {0.3, 0.3, 0.3}));
  for (double x : {-0.06, 0.06})
    pedestal.add_part(x < 0 ? "pear" : "apple", box({x, 1.01, 0}, {0.02, 0.02, 0.02}));
  const Model source(legged), target(pedestal);
  const Shape_blend blend = blend_of(source, target, {{"top", "top"}});
  std::set<std::pair<double, double>> come, go; // times of growing and shrinking
  for (const Blend_task& task : blend.schedules()[0].tasks) {
    if (task.type == Blend_task_type::MORPH) continue;
    if (task.type == Blend_task_type::GROW) come.emplace(task.begin, task.end);
    if (task.type == Blend_task_type::SHRINK) go.emplace(task.begin, task.end);
  }
  REQUIRE(come.size() == 2); // one for the parts below the top, one for those above it
  REQUIRE(go.size() == 2);
  CHECK(come == go); // old and new are never in one place
  int supports = 0;
  constexpr int steps = 50;
  for (int i = 1; i < steps; ++i) {
    const Segmented_shape shape = blend(double(i) / steps);
    supports += std::any_of(shape.parts().begin(), shape.parts().end(), [](const Shape_part& part) {
      return (part.name == "left~" || part.name == "~column") && part.mesh.points.row(1).minCoeff() < 0.02;
    });
  }
  CHECK(supports == steps - 1); // at any time, a support reaches the ground
}

TEST_CASE("While all is exchanged, the shape is as high as before and after")
{
  Segmented_shape block("block"), needle("needle");
  block.add_part("low", box({0, 0.3, 0}, {1, 0.6, 1}));
  block.add_part("high", box({0, 0.8, 0}, {1, 0.4, 1}));
  needle.add_part("foot", box({0, 0.05, 0}, {0.1, 0.1, 0.1}));
  needle.add_part("point", box({0, 0.55, 0}, {0.02, 0.9, 0.02}));
  const Model source(block), target(needle);
  const Shape_blend blend = blend_of(source, target, {});
  const double change = internal::Part_morph::change;
  for (double t : {change - 0.005, change - 0.003, change - 0.002, change - 0.001, change + 0.001})
    CHECK(height_error(blend, t) < 1e-6);
}

TEST_CASE("Parts that replace none appear together after the exchanges; parts not replaced vanish together before them")
{
  Segmented_shape plain("plain"), with_knobs("with knobs");
  for (Segmented_shape* shape : {&plain, &with_knobs}) {
    shape->add_part("foot", box({0, -0.05, 0}, {2, 0.1, 0.4}));
    shape->add_part("base", box({0, 0.3, 0}, {1, 0.6, 0.5}));
  }
  with_knobs.add_part("knob", box({-0.7, 0.05, 0.1}, {0.1, 0.1, 0.1}));
  with_knobs.add_part("other", box({0.8, 0.15, -0.1}, {0.1, 0.3, 0.1}));
  const Model few(plain), more(with_knobs);
  const auto windows = [](const Model& source, const Model& target) {
    std::set<std::pair<double, double>> result;
    const Shape_blend blend = blend_of(source, target, {{"foot", "foot"}, {"base", "base"}});
    for (const Blend_task& task : blend.schedules()[0].tasks)
      if (task.type != Blend_task_type::MORPH) result.emplace(task.begin, task.end);
    return result;
  };
  const std::set<std::pair<double, double>> come = windows(few, more), go = windows(more, few);
  REQUIRE(come.size() == 1);
  CHECK(come.begin()->first >= 0.55);
  CHECK(come.begin()->second <= 0.8);
  REQUIRE(go.size() == 1);
  CHECK(go.begin()->second <= 0.35);
}

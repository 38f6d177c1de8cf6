// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "blend/schedules.h"
#include "box_models.h"
#include "model_files.h"

#include <CGAL/Shape_correspondence/IO/write_blend.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/blend_shapes.h>
#include <CGAL/Shape_correspondence/build_structural_graph.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <sstream>
#include <string>
#include <vector>

// Measures of in-between shapes, sizes, schedules, and pairs of low confidence.

using namespace CGAL::Shape_correspondence;
using Catch::Matchers::Contains;
using namespace box_models;

namespace {

double height_of(const Segmented_shape& shape)
{
  double low = 1e9, high = -1e9;
  for (const Shape_part& part : shape.parts()) {
    low = std::min(low, part.mesh.points.row(1).minCoeff());
    high = std::max(high, part.mesh.points.row(1).maxCoeff());
  }
  return high - low;
}

using contacts_box = Eigen::AlignedBox3d;

contacts_box box_of(const Shape_part& part)
{
  return {part.mesh.points.rowwise().minCoeff(), part.mesh.points.rowwise().maxCoeff()};
}

} // namespace

TEST_CASE("Options and numbers of frames that make no sense are refused")
{
  const Box_model model = model_of(stand());
  const Correspondence same = same_parts(stand().size());
  const auto refused = [&](const auto& set) {
    Blend_options options;
    set(options);
    return model_files::complaint(
        [&] { Shape_blend(model.graph, model.shape, model.graph, model.shape, same, options); });
  };
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (int samples : {0, -1, 2000000000})
    CHECK_THAT(refused([&](Blend_options& o) { o.samples = samples; }), Contains("sample"));
  for (double value : {nan, -0.1, 1.1}) {
    CHECK_THAT(refused([&](Blend_options& o) { o.min_confidence = value; }), Contains("confidence"));
    CHECK_THAT(refused([&](Blend_options& o) { o.contact_tolerance = value; }), Contains("contact tolerance"));
  }
  const Shape_blend blend = blend_of(model, model, same);
  for (int frames : {-1, 0, 1, 10001}) {
    std::ostringstream out;
    CHECK_THAT(model_files::complaint([&] { IO::write_blend_glb(out, blend, same, frames); }), Contains("10000"));
    CHECK(out.str().empty());
  }
}

TEST_CASE("Missing support and gaps between parts are measured")
{
  const Box_model model = model_of(stand());
  const std::array<internal::Blend_input, 2> inputs = {internal::Blend_input{model.graph, model.shape, 0},
                                                       internal::Blend_input{model.graph, model.shape, 0}};
  const internal::Blend_structure blend(inputs, same_parts(3), {});
  constexpr std::size_t base = 0, top = 2;
  const auto raised = [&](std::size_t part, double by) {
    internal::In_between_shape shape(blend, internal::ranked_schedules(blend, {})[0].tasks, 0.5);
    shape.points[part].row(1).array() += by;
    return shape.quality();
  };
  CHECK(raised(base, 0).support == 0);
  CHECK(raised(base, 0.05).support == 1);
  CHECK(raised(top, 0.03).apart == Approx(0.03).epsilon(0.01));
  CHECK(raised(top, 0.003).apart == 0);
}

TEST_CASE("Parts turn by the least rotation between their boxes")
{
  // The top becomes as high as it was wide, and as wide as it was high: it is stretched, not rotated
  std::vector<Named_box> boxes = stand();
  boxes[2].size = {0.8, 0.5, 0.6};
  boxes[2].middle.y() = 1.15;
  const Box_model source = model_of(boxes);
  boxes[2].size = {0.5, 0.8, 0.6};
  boxes[2].middle.y() = 1.3;
  const Box_model target = model_of(boxes);
  Blend_options options;
  options.size = Blend_size::SAME;
  const Shape_blend blend = blend_of(source, target, same_parts(3), options);
  for (double t : {0.25, 0.5, 0.75}) {
    const double width = (1 - t) * 0.8 / 1.4 + t * 0.5 / 1.7;
    CHECK(box_of(blend(t).parts()[2]).sizes().x() == Approx(width).epsilon(0.02));
  }
}

TEST_CASE("A part inside an open box is hidden, a part above it is not")
{
  const Part_mesh box = box_shapes::box({0, 0.5, 0}, {1, 1, 1});
  Part_mesh crate = {box.points, {}};
  for (const auto& t : box.triangles.colwise())
    if (box.points(1, t[0]) + box.points(1, t[1]) + box.points(1, t[2]) < 3) { // leaves out the upper face
      crate.triangles.conservativeResize(3, crate.triangles.cols() + 1);
      crate.triangles.rightCols(1) = t;
    }
  REQUIRE(crate.triangles.cols() < box.triangles.cols());
  const auto share = [&](double height) {
    std::vector<internal::Blend_part> parts(2);
    parts[0].mesh = box_shapes::box({0, height, 0}, {0.2, 0.2, 0.2});
    parts[1].mesh = crate;
    std::vector<internal::Seen_surface> seen;
    for (std::size_t i : {0u, 1u}) {
      parts[i].set_ends();
      seen.emplace_back(parts, i, 0, parts[i].mesh.points);
    }
    return internal::share_inside(seen[0], seen[1]);
  };
  CHECK(share(0.5) == 1);
  CHECK(share(1.2) == 0);
}

TEST_CASE("The size changes by equal factors in equal times; either shape may be given the other's size")
{
  constexpr double scale = 27;
  const Box_model source = model_of(stand()), target = model_of(stand(), scale);
  const auto blended = [&](Blend_size size) {
    Blend_options options;
    options.size = size;
    return blend_of(source, target, same_parts(3), options);
  };
  const Shape_blend both = blended(Blend_size::BLEND);
  CHECK(height_of(both(0.5)) == Approx(std::sqrt(scale)));
  CHECK(height_of(both(1)) == Approx(scale));
  for (double t : {0., 0.3, 0.7, 1.}) {
    CHECK(height_of(blended(Blend_size::SOURCE)(t)) == Approx(1));
    CHECK(height_of(blended(Blend_size::TARGET)(t)) == Approx(scale));
    CHECK(height_of(blended(Blend_size::SAME)(t)) == Approx(1));
  }
  // A shape that is elsewhere in its file and rotated is brought to the same place: on the ground, in the middle
  Box_model away{Segmented_shape("away"), {}};
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.4, Point::UnitY()).toRotationMatrix();
  for (const Shape_part& part : target.shape.parts())
    away.shape.add_part(part.name, {(turn * part.mesh.points).colwise() + Point(13, 5, 0), part.mesh.triangles});
  Structure_options options;
  options.abstraction.abstractor = Bounding_box_abstraction();
  away.graph = build_structural_graph(away.shape, options);
  for (const Shape_blend& blend : {blend_of(source, away, same_parts(3)), blend_of(away, source, same_parts(3))})
    for (double t : {0., 0.2, 0.5, 0.8, 1.}) {
      contacts_box box;
      const Segmented_shape shape = blend(t);
      for (const Shape_part& part : shape.parts())
        box.extend(box_of(part));
      CHECK(std::abs(box.min().y()) < 1e-3 * box.sizes().y());
      CHECK(box.center().x() == Approx(0).margin(0.02 * box.sizes().x()));
      CHECK(box.center().z() == Approx(0).margin(0.02 * box.sizes().z()));
    }
}

TEST_CASE("Pairs of low confidence do not morph; similar parts in one place are exchanged for each other")
{
  const Box_model model = model_of(stand());
  Correspondence correspondence = same_parts(3);
  for (Part_correspondence& pair : correspondence.pairs)
    pair.confidence = 0.9;
  correspondence.pairs[2].confidence = 0.3;
  const auto morphs = [&](double least) {
    Blend_options options;
    options.min_confidence = least;
    const Shape_blend blend = blend_of(model, model, correspondence, options);
    const auto& tasks = blend.schedules()[0].tasks;
    return std::count_if(tasks.begin(), tasks.end(),
                         [](const Blend_task& task) { return task.type == Blend_task_type::MORPH; });
  };
  CHECK(morphs(0) == 3);
  CHECK(morphs(0.5) == 2);
  const Shape_blend unsure = blend_of(model, model, correspondence);
  const Blend_task& task = unsure.schedules()[0].tasks[2];
  CHECK(task.type == Blend_task_type::EXCHANGE);
  CHECK(task.obstacle == Blend_obstacle::NONE);
  CHECK(task.source == 2);
  CHECK(task.target == 2);
  correspondence.pairs[2].confidence = std::numeric_limits<double>::quiet_NaN(); // no confidence: accepted
  CHECK(morphs(0.5) == 3);
}

TEST_CASE("All motions have a constant speed, by any schedule")
{
  std::vector<Named_box> wide = stand();
  wide[2].size.x() = 2;
  const Box_model source = model_of(stand()), target = model_of(wide);
  const auto width = [](const Segmented_shape& shape) {
    const Points& points = shape.parts()[2].mesh.points;
    return points.row(0).maxCoeff() - points.row(0).minCoeff();
  };
  for (const std::string& name : Shape_blend::schedule_names()) {
    INFO(name);
    Blend_options options;
    options.schedule = name;
    const Shape_blend blend = blend_of(source, target, same_parts(3), options);
    REQUIRE(blend.schedules().size() == 1);
    for (double t : {0.02, 0.3, 0.98})
      CHECK(width(blend(t)) == Approx(1 + t).epsilon(0.01));
  }
}

TEST_CASE("A schedule may be chosen; blends by different ones differ, and the best one is that of all")
{
  std::vector<Named_box> with_lamp = stand(), with_pot = stand();
  with_lamp.push_back({"lamp", {0.3, 1.2, 0}, {0.3, 0.4, 0.3}});
  with_lamp.push_back({"shelf", {0, 0.5, 0.2}, {0.3, 0.05, 0.3}});
  with_pot.push_back({"pot", {0.3, 1.2, 0}, {0.1, 0.4, 0.1}});
  with_pot.push_back({"ring", {0, 0.5, 0.2}, {0.1, 0.2, 0.3}});
  const Box_model source = model_of(with_lamp), target = model_of(with_pot);
  Blend_options options;
  options.schedule = "no such";
  CHECK_THROWS_AS(blend_of(source, target, same_parts(3), options), Invalid_input);
  options.schedule = "";
  const Shape_blend all = blend_of(source, target, same_parts(3), options);
  CHECK(all.schedules().size() == Shape_blend::schedule_names().size());
  const std::vector<Shape_blend> different = all.different_blends();
  REQUIRE(different.size() > 1);
  CHECK(different[0].schedules()[0].name == all.schedules()[0].name);
  const auto names = [&](std::size_t schedule) {
    std::set<std::string> result;
    const Segmented_shape shape = different[schedule](0.5);
    for (const Shape_part& part : shape.parts())
      result.insert(part.name);
    return result;
  };
  CHECK(names(0) != names(1));
  // Nothing moves, shrinks or grows: all schedules give the same shapes
  CHECK(blend_of(source, source, same_parts(3), options).different_blends().size() == 1);
}

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/eigen_system.h"
#include "blend/Affine_motion.h"
#include "blend/Blend_ends.h"
#include "blend/blend_quality.h"
#include "blend/ease.h"
#include "blend/in_between_steps.h"
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
#include <functional>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

// What one sees of shapes in between, what motions may do to parts, sizes, schedules, and pairs that are not believed.

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

bool is_told(const std::vector<std::string>& faults, const std::string& words, const std::string& part)
{
  return std::any_of(faults.begin(), faults.end(), [&](const std::string& fault) {
    return fault.find(words) != std::string::npos && fault.find('\'' + part + '\'') != std::string::npos;
  });
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

TEST_CASE("Motions that close gaps stretch a part within bounds, all of them together")
{
  internal::Stretch stretch;
  Eigen::Matrix3d map = Eigen::Matrix3d::Identity();
  const auto stretches = [&] {
    return Eigen::Vector3d(internal::eigen_system(map.transpose() * map).values.cwiseMax(0).cwiseSqrt());
  };
  internal::Affine_motion motion;
  motion.translation = Point(0.1, 0.2, 0.3);
  motion.gradient.diagonal() = Point(0.2, -0.1, 0);
  for (int i = 0; i < 6; ++i) {
    const internal::Affine_motion bounded = stretch.bounded(motion);
    CHECK(bounded.translation == motion.translation);
    CHECK(stretch.is_at_bound() == (i > 0)); // 1.2² is over 1.4
    map = (Eigen::Matrix3d::Identity() + bounded.gradient) * map;
    CHECK(stretches().maxCoeff() < internal::most_stretch + 1e-9);
    CHECK(stretches().minCoeff() > internal::least_stretch - 1e-9);
  }
  CHECK(stretches().maxCoeff() == Approx(internal::most_stretch));
  CHECK(stretches().minCoeff() == Approx(internal::least_stretch));
  for (double flat : {-1., -3.}) { // to nothing, and inside out
    motion.gradient = flat * Point::UnitX() * Point::UnitX().transpose();
    map = (Eigen::Matrix3d::Identity() + stretch.bounded(motion).gradient) * map;
    CHECK(map.determinant() > 0);
    CHECK(stretches().minCoeff() > internal::least_stretch - 1e-9);
  }
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1, Point(1, 2, 2) / 3).toRotationMatrix();
  motion.gradient = turn - Eigen::Matrix3d::Identity();
  internal::Stretch fresh;
  CHECK((fresh.bounded(motion).gradient - motion.gradient).norm() < 1e-12);
  CHECK(!fresh.is_at_bound());
}

TEST_CASE("A body that is stretched as far as it may be is moved as it is")
{
  const auto moved = [](bool is_rigid) {
    internal::Affine_motion_solver solver({{Point::Zero(), 1, 0.01, is_rigid}, {Point(1, 0, 0), 1, 1e9, true}});
    solver.add_contact(0, Point(0.5, 0, 0), 1, Point(1, 0, 0), Point(0.5, 0, 0));
    return solver.solve()[0];
  };
  CHECK(moved(false).gradient.norm() > 1e-3);
  CHECK(moved(true).gradient.norm() < 1e-3);
  CHECK(moved(true).displacement({0.5, 0, 0}).x() == Approx(0.5).margin(0.01));
}

TEST_CASE("What is wrong with a shape in between is told, with the part")
{
  const Box_model model = model_of(stand());
  const std::array<internal::Blend_input, 2> inputs = {internal::Blend_input{model.graph, model.shape, 0},
                                                       internal::Blend_input{model.graph, model.shape, 0}};
  const internal::Blend_structure blend(inputs, same_parts(3), {});
  constexpr std::size_t base = 0, column = 1, top = 2;
  const auto faults = [&](std::size_t part, const std::function<void(Points&)>& harm) {
    internal::In_between_shape shape =
        internal::in_between_shape(blend, internal::Task_times(3, std::array<double, 2>{0., 1.}), 0.5);
    harm(shape.moving_points(part));
    return internal::check(shape).faults;
  };
  CHECK(faults(column, [](Points&) {}).empty());
  const auto scaled = [](const Point& factors) {
    return [factors](Points& points) {
      const Point middle = (points.rowwise().minCoeff() + points.rowwise().maxCoeff()) / 2;
      points = (factors.asDiagonal() * (points.colwise() - middle)).colwise() + middle;
    };
  };
  CHECK(is_told(faults(top, scaled({1, 0.3, 1})), "thinner", "top~top"));
  CHECK(!is_told(faults(top, scaled({1, 0.7, 1})), "thinner", "top~top"));
  CHECK(is_told(faults(top, scaled({1.8, 1, 1.8})), "surface is larger", "top~top"));
  CHECK(is_told(faults(top, scaled({1.8, 1, 1.8})), "volume is larger", "top~top"));
  CHECK(!is_told(faults(top, scaled({1.1, 1, 1.1})), "larger", "top~top"));
  const auto crumpled = [](Points& points) {
    for (Eigen::Index i = 0; i < points.cols(); i += 2)
      points.col(i) += Point(0.7 * std::sin(double(i)), 0, 0.4 * std::cos(double(i)));
  };
  CHECK(is_told(faults(base, crumpled), "torn or folded", "base~base"));
  const auto shifted = [](const Point& by) { return [by](Points& points) { points.colwise() += by; }; };
  CHECK(is_told(faults(column, shifted({0, 0.05, 0})), "moved farther than its neighbours", "column~column"));
  CHECK(!is_told(faults(column, shifted({0, 0.01, 0})), "moved farther than its neighbours", "column~column"));
  CHECK(is_told(faults(top, shifted({0, -0.88, 0})), "gone into other parts", "top~top"));
}

TEST_CASE("The tree of a part goes where the part goes, whatever moves it, and stays the same object")
{
  const Box_model model = model_of(stand());
  const std::array<internal::Blend_input, 2> inputs = {internal::Blend_input{model.graph, model.shape, 0},
                                                       internal::Blend_input{model.graph, model.shape, 0}};
  const internal::Blend_structure blend(inputs, same_parts(3), {});
  internal::In_between_shape shape(blend, internal::Task_times(3, std::array<double, 2>{0., 1.}), 0.5);
  const auto is_around = [&](std::size_t part) {
    return shape.tree(part).box().isApprox(internal::box_of(shape.points(part)));
  };
  const auto* tree = &shape.tree(1);
  CHECK(is_around(1));
  shape.apply({Point::Zero(), Point(0, 0.2, 0), Eigen::Matrix3d::Zero()}, 1);
  CHECK(is_around(1));
  shape.stretch({Point::Zero(), Point::Zero(), 0.1 * Eigen::Matrix3d::Identity()}, 1);
  CHECK(is_around(1));
  shape.moving_points(1) *= 2;
  CHECK(is_around(1));
  CHECK(&shape.tree(1) == tree);
  shape.moving_points(2).row(0).array() += 1;
  CHECK(shape.trees()[2]->box().isApprox(internal::box_of(shape.points(2))));
  shape.drop_trees();
  CHECK(is_around(2));
}

TEST_CASE("What is not symmetric any more is told, with the part")
{
  std::vector<Named_box> boxes = stand();
  boxes.push_back({"peg", {0.3, 1.02, 0}, {0.04, 0.04, 0.04}});
  Box_model model = model_of(boxes);
  structure(model.graph).frame.axes.setIdentity();
  structure(model.graph).frame.mirror_x = true;
  const std::array<internal::Blend_input, 2> inputs = {internal::Blend_input{model.graph, model.shape, 0},
                                                       internal::Blend_input{model.graph, model.shape, 0}};
  const internal::Blend_structure blend(inputs, same_parts(4), {});
  const auto faults = [&](std::size_t part, double by) {
    internal::In_between_shape shape =
        internal::in_between_shape(blend, internal::Task_times(4, std::array<double, 2>{0., 1.}), 0.5);
    shape.moving_points(part).row(0).array() += by;
    return internal::check(shape).faults;
  };
  CHECK(!is_told(faults(1, 0), "mirror image", "column~column"));
  CHECK(is_told(faults(1, 0.3), "farther from its mirror image", "column~column"));
  CHECK(is_told(faults(3, 2), "no mirror image", "peg~peg"));
}

TEST_CASE("Parts that pass through each other are told")
{
  const std::vector<Named_box> here = {{"base", {0, 0.05, 0}, {2, 0.1, 1}},
                                       {"left", {-0.6, 0.45, 0}, {0.3, 0.7, 0.3}},
                                       {"right", {0.6, 0.35, 0}, {0.25, 0.5, 0.25}},
                                       {"mast", {0, 0.55, 0.4}, {0.1, 0.9, 0.1}}};
  std::vector<Named_box> there = here;
  there[1].middle.x() = 0.6, there[2].middle.x() = -0.6;
  const Shape_blend blend = blend_of(model_of(here), model_of(there), same_parts(4));
  CHECK(blend.check(0.5).quality.overlap > Shape_blend::overlap_tolerance);
  CHECK(blend.check(0.05).quality.overlap == 0);
  CHECK(blend.check(0).quality.overlap == 0);
}

TEST_CASE("Size goes over by equal factors in equal times; either shape may be given the other's size")
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
  // One shape in two units and elsewhere is scaled about one point
  Box_model away{Segmented_shape("away"), {}};
  for (const Shape_part& part : target.shape.parts())
    away.shape.add_part(part.name, {part.mesh.points.colwise() + Point(13, 5, 0), part.mesh.triangles});
  Structure_options options;
  options.abstraction.abstractor = Bounding_box_abstraction();
  away.graph = build_structural_graph(away.shape, options);
  const Shape_blend moving = blend_of(source, away, same_parts(3));
  const Point fixed = -Point(13, 5, 0) / (scale - 1); // of the map from the source to the target
  const auto foot = [&](double t) {
    const Segmented_shape shape = moving(t);
    const Points& points = shape.parts()[0].mesh.points;
    return Point((points.rowwise().minCoeff() + points.rowwise().maxCoeff()) / 2);
  };
  CHECK((foot(0.5) - fixed).norm() == Approx(std::sqrt(scale) * (foot(0) - fixed).norm()).epsilon(1e-3));
}

TEST_CASE("Pairs that are not believed shrink and grow")
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
  correspondence.pairs[2].confidence = std::numeric_limits<double>::quiet_NaN(); // not told: believed
  CHECK(morphs(0.5) == 3);
}

TEST_CASE("No schedule has idle time; all motions start and stop gently")
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
    if (name != "from the ground up") CHECK(width(blend(0.25)) > 1.1);
    CHECK(width(blend(0.75)) < 1.95);
    CHECK(width(blend(0.02)) < 1.01);
    CHECK(width(blend(0.98)) > 1.99);
  }
  CHECK(internal::eased(0.5) == Approx(0.5));
  for (double done : {0., 0.1, 0.5, 0.8, 1.})
    CHECK(internal::eased(internal::time_of(done)) == Approx(done).margin(1e-12));
}

TEST_CASE("A schedule may be chosen; blends by different ones differ, and the best one is that of all")
{
  const Box_model source = model_of(stand());
  std::vector<Named_box> more = stand();
  more[2].middle.x() = 0.2;
  more.push_back({"lamp", {0.2, 1.2, 0}, {0.3, 0.4, 0.3}});
  const Box_model target = model_of(more);
  Blend_options options;
  options.schedule = "no such";
  CHECK_THROWS_AS(blend_of(source, target, same_parts(3), options), Invalid_input);
  options.schedule = "";
  const Shape_blend best = blend_of(source, target, same_parts(3), options);
  options.rank_all = true;
  const Shape_blend all = blend_of(source, target, same_parts(3), options);
  CHECK(all.schedules().size() == Shape_blend::schedule_names().size());
  CHECK(best.schedules()[0].name == all.schedules()[0].name);
  const std::vector<Shape_blend> different = all.different_blends();
  REQUIRE(different.size() > 1);
  CHECK(different[0].schedules()[0].name == all.schedules()[0].name);
  const Segmented_shape first = different[0](0.5), second = different[1](0.5);
  const bool is_other = first.parts().size() != second.parts().size() ||
                        std::abs(height_of(first) - height_of(second)) > 1e-3 ||
                        (first.parts()[2].mesh.points - second.parts()[2].mesh.points).norm() > 1e-3;
  CHECK(is_other);
  // Nothing that shrinks or grows: all but the one that goes from the ground up are the same
  CHECK(blend_of(source, source, same_parts(3), options).different_blends().size() == 1);
}

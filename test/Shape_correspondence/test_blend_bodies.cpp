// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "blend/Blend_part.h"
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
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

// Sets of parts that correspond but have no map are exchanged one after the other, each in its place.

using namespace CGAL::Shape_correspondence;
using namespace blend_checks;
using box_shapes::box;

namespace {

struct Model
{
  explicit Model(Segmented_shape given) : shape(std::move(given)), graph(build_structural_graph(shape)) {}

  Segmented_shape shape;
  Structural_graph graph;
};

/// Two storeys, each of four posts or of two boards that cross each other where the posts are.
constexpr double height = 0.5;
constexpr double posts_width = 0.9;
constexpr std::array<double, 2> boards_widths = {1.2, 0.8};

std::string name(const char* part, std::size_t storey)
{
  constexpr std::array<const char*, 3> places = {"_below", "_above", "_inside"};
  return std::string(part) + places[storey];
}

/// \param add_inside whether there is less of the same inside the upper storey
Model posts_model(bool add_inside = false)
{
  Segmented_shape result("posts");
  for (std::size_t storey : {0u, 1u})
    for (int side : {-1, 1})
      for (bool is_in_depth : {false, true}) {
        const Point middle(is_in_depth ? 0 : 0.4 * side, (double(storey) + 0.5) * height, is_in_depth ? 0.2 * side : 0);
        result.add_part(name("post", storey) + std::to_string(result.parts().size()), box(middle, {0.1, height, 0.1}));
      }
  if (add_inside)
    for (const Point& middle : {Point(-0.3, 0.7, 0), Point(0, 0.7, -0.12), Point(0.3, 0.7, 0), Point(0, 0.7, 0.12)})
      result.add_part(name("post", 2) + std::to_string(result.parts().size()), box(middle, {0.06, 0.4, 0.06}));
  return Model(result);
}

Model boards_model(bool add_inside = false)
{
  Segmented_shape result("boards");
  for (std::size_t storey : {0u, 1u}) {
    const Point middle(0, (double(storey) + 0.5) * height, 0);
    result.add_part(name("long", storey), box(middle, {boards_widths[storey], height, 0.05}));
    result.add_part(name("deep", storey), box(middle, {0.05, height, 0.5}));
  }
  if (add_inside) {
    result.add_part(name("long", 2), box({0, 0.7, 0}, {0.75, 0.4, 0.03}));
    result.add_part(name("deep", 2), box({0, 0.7, 0}, {0.03, 0.4, 0.35}));
  }
  return Model(result);
}

/// All posts correspond to both boards of their storey; boards cut up are unlike posts.
Correspondence posts_and_boards(std::size_t storeys = 2)
{
  Correspondence result;
  for (std::size_t storey = 0; storey < storeys; ++storey)
    for (std::size_t post : {0u, 1u, 2u, 3u})
      for (std::size_t board : {0u, 1u})
        result.pairs.push_back({4 * storey + post, 2 * storey + board});
  return result;
}

Shape_blend blend_of(const Model& source, const Model& target, const Correspondence& correspondence,
                     const std::string& schedule = "")
{
  Blend_options options;
  options.schedule = schedule;
  return Shape_blend(source.graph, source.shape, target.graph, target.shape, correspondence, options);
}

/// What there is below, above and inside: the first letters of the parts.
std::string look(const Segmented_shape& shape)
{
  std::string result;
  for (std::size_t storey : {0u, 1u, 2u})
    for (const char* part : {"post", "long", "deep"})
      for (const Shape_part& there : shape.parts())
        if (there.name.find(name(part, storey)) != std::string::npos) result += part[0];
  return result;
}

const std::string posts = "pppp", boards = "ld";

double width_of(const Segmented_shape& shape, const std::string& name)
{
  for (const Shape_part& part : shape.parts())
    if (part.name == name) return internal::box_of(part.mesh.points).sizes().x();
  return 0;
}

/// How far a part is from the nearest other one, at most.
double farthest_from_all(const Segmented_shape& shape)
{
  const std::vector<Triangle_tree> trees = trees_of(shape);
  double result = 0;
  for (const Triangle_tree& tree : trees) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Triangle_tree& other : trees)
      if (&other != &tree) nearest = std::min(nearest, tree.nearly_closest(other).squared);
    result = std::max(result, std::sqrt(nearest));
  }
  return result;
}

const Model& data(const std::string& name)
{
  static std::map<std::string, Model> known;
  const auto found = known.find(name);
  if (found != known.end()) return found->second;
  return known.emplace(name, Model(IO::read_segmented_shape(SHAPE_CORRESPONDENCE_DATA_DIR "/" + name))).first->second;
}

} // namespace

TEST_CASE("Sets of parts without a map are exchanged one after the other, each in its place")
{
  const Model source = posts_model(), target = boards_model();
  const Shape_blend blend = blend_of(source, target, posts_and_boards());
  CHECK(blend.schedules()[0].name == "from the ground up");
  const Shape_blend down = blend_of(source, target, posts_and_boards(), "from the top down");
  const Shape_blend in_chains = blend_of(source, target, posts_and_boards(), "chain by chain");
  std::set<std::string> seen, seen_down, seen_in_chains;
  for (double t = 0.05; t < 1; t += 0.05) {
    INFO("t = " << t);
    const Segmented_shape shape = blend(t);
    seen.insert(look(shape));
    seen_down.insert(look(down(t)));
    seen_in_chains.insert(look(in_chains(t)));
    CHECK(farthest_from_all(shape) < 0.01);
    for (std::size_t storey : {0u, 1u}) // what comes is as wide as is due between both, other than the whole
      if (const double width = width_of(shape, '~' + name("long", storey)); width > 0)
        CHECK(width == Approx((1 - t) * posts_width + t * boards_widths[storey]).epsilon(0.01));
  }
  CHECK(seen == std::set<std::string>{posts + posts, boards + posts, boards + boards});
  CHECK(seen_down == std::set<std::string>{posts + posts, posts + boards, boards + boards});
  CHECK(seen_in_chains == std::set<std::string>{posts + posts, boards + boards});
}

TEST_CASE("What is inside a set changes with it")
{
  const Shape_blend blend = blend_of(posts_model(true), boards_model(true), posts_and_boards(3), "from the ground up");
  std::set<std::string> seen;
  for (double t = 0.05; t < 1; t += 0.05)
    seen.insert(look(blend(t)));
  CHECK(seen == std::set<std::string>{posts + posts + posts, boards + posts + posts, boards + boards + boards});
}

TEST_CASE("Shapes in which sets are exchanged one by one hang together, and are as good as without")
{
  const std::vector<std::array<std::string, 2>> pairs = {{"chair_four_legged", "chair_slatted"},
                                                         {"chair_slatted", "chair_spindle"},
                                                         {"chair_spindle", "chair_swivel"},
                                                         {"table_four_legged", "table_pedestal"},
                                                         {"airplane_propeller", "airplane_twin_engine"},
                                                         {"tricycle", "bicycle"}};
  for (const auto& [from, to] : pairs) {
    INFO(from << " to " << to);
    const Model &source = data(from), &target = data(to);
    const Shape_blend blend = blend_of(source, target, find_correspondence(source.graph, target.graph));
    const std::vector<Blend_schedule>& schedules = blend.schedules();
    const auto in_chains = std::find_if(schedules.begin(), schedules.end(), [](const Blend_schedule& schedule) {
      return schedule.name == "chain by chain";
    });
    REQUIRE(in_chains != schedules.end());
    for (const Blend_measure& measure : blend_measures())
      if (std::string(measure.name) != "volume")
        CHECK(schedules[0].quality.*measure.value <=
              std::max(measure.tolerance, 1.1 * (in_chains->quality.*measure.value)));
    for (const Blend_schedule& schedule : schedules)
      CHECK(schedule.quality.apart < 0.05);
  }
}

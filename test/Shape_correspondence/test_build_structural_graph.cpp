// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "box_shapes.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/build_structural_graph.h>

#include <catch2/catch.hpp>

#include <algorithm>

using namespace box_shapes;

namespace {

std::set<Names> group_names(const Structural_graph& graph)
{
  std::set<Names> result;
  for (std::size_t v = 0; v < num_vertices(graph); ++v) {
    Names names;
    for (std::size_t part : graph[v].parts)
      names.insert(structure(graph).parts[part].name);
    result.insert(names);
  }
  return result;
}

const std::set<Names> TABLE_GROUPS = {{"plate"}, {"leg_1", "leg_2", "leg_3", "leg_4"}};

} // namespace

TEST_CASE("The graph of a table")
{
  Structure_times times;
  const Structural_graph graph = build_structural_graph(table(), {}, &times);
  CHECK(is_valid_structural_graph(graph, true));
  CHECK(group_names(graph) == TABLE_GROUPS);
  REQUIRE(num_edges(graph) == 1);
  CHECK(graph[*edges(graph).first].contacts.size() == 4);
  CHECK(structure(graph).name == "table");
  CHECK_FALSE(structure(graph).parts[1].is_sheet());
  CHECK(structure(graph).frame.height == Approx(1.0).epsilon(0.02));
  CHECK(times.abstraction > 0);
  CHECK(times.structure > 0);
  CHECK(structure(graph).warnings.empty());
}

TEST_CASE("Sequential and parallel building agree to the bit")
{
  const Structural_graph a = build_structural_graph<CGAL::Sequential_tag>(star_stool());
  const Structural_graph b = build_structural_graph<CGAL::Parallel_tag>(star_stool());
  CHECK(group_names(a) == group_names(b));
  REQUIRE(structure(a).contacts.size() == structure(b).contacts.size());
  for (std::size_t i = 0; i < structure(a).contacts.size(); ++i) {
    CHECK(structure(a).contacts[i].parts == structure(b).contacts[i].parts);
    CHECK(structure(a).contacts[i].parameters[0] == structure(b).contacts[i].parameters[0]);
    CHECK(structure(a).contacts[i].parameters[1] == structure(b).contacts[i].parameters[1]);
  }
  for (std::size_t i = 0; i < structure(a).parts.size(); ++i)
    CHECK(structure(a).parts[i].control_points() == structure(b).parts[i].control_points());
}

TEST_CASE("The graph does not depend on pose and order")
{
  std::mt19937 random(5);
  const Segmented_shape shape = table();
  const Structural_graph graph =
      build_structural_graph(moved(shape, random_motion(random), random_order(shape.parts().size(), random)));
  CHECK(group_names(graph) == TABLE_GROUPS);
  CHECK(structure(graph).contacts.size() == 4);
}

TEST_CASE("The order of parts and their names change no bit")
{
  const Segmented_shape shape = star_stool();
  std::mt19937 random(7);
  const std::vector<std::size_t> order = random_order(shape.parts().size(), random);
  Segmented_shape shuffled(shape.name());
  for (std::size_t i : order)
    shuffled.add_part("x" + shape.parts()[i].name, shape.parts()[i].mesh);
  const Structural_graph a = build_structural_graph(shape), b = build_structural_graph(shuffled);
  CHECK(structure(a).frame.axes == structure(b).frame.axes);
  CHECK(structure(a).frame.origin == structure(b).frame.origin);
  CHECK(structure(a).frame.height == structure(b).frame.height);
  for (std::size_t k = 0; k < order.size(); ++k) {
    const Part_abstraction &part = structure(a).parts[order[k]], &same = structure(b).parts[k];
    INFO(part.name);
    CHECK(same.name == "x" + part.name);
    CHECK(same.report.method == part.report.method);
    CHECK(same.control_points() == part.control_points());
    CHECK(same.surface == part.surface);
    CHECK(same.volume == part.volume);
  }
}

TEST_CASE("Parts that fall back to their bounding box are named")
{
  Structure_options hasty;
  hasty.abstraction.time_limit = 0;
  const Structural_graph graph = build_structural_graph(table(), hasty);
  const auto& warnings = structure(graph).warnings;
  REQUIRE(!warnings.empty());
  CHECK(std::any_of(warnings.begin(), warnings.end(),
                    [](const std::string& w) { return w.find("'plate'") != std::string::npos; }));
  CHECK_THAT(warnings.front(), Catch::Contains("more time than allowed"));
}

TEST_CASE("Parts that branch are named in one warning")
{
  Structure_options options;
  options.abstraction.abstractor = [](const Shape_part& part, const Abstraction_options& abstraction) {
    Part_abstraction result = Bounding_box_abstraction()(part, abstraction);
    result.report.branching = part.name != "plate";
    return result;
  };
  const auto warnings = structure(build_structural_graph(table(), options)).warnings;
  REQUIRE(warnings.size() == 1);
  CHECK_THAT(warnings.front(), Catch::Contains("branch") && Catch::Contains("'leg_1'") && Catch::Contains("'leg_4'") &&
                                   !Catch::Contains("plate"));
  CHECK(structure(build_structural_graph(table())).warnings.empty());
}

TEST_CASE("A shape needs two parts")
{
  Segmented_shape shape("lonely");
  CHECK_THROWS_AS(build_structural_graph(shape), Invalid_input);
  shape.add_part("only", box({0, 0, 0}, {1, 1, 1}));
  CHECK_THROWS_WITH(build_structural_graph(shape), Catch::Contains("'lonely'") && Catch::Contains("only one part"));
  Shape_structure structure;
  CHECK_THROWS_AS(complete_structural_graph(structure, {}), Invalid_input);
}

TEST_CASE("Completing a graph keeps the groups and contacts that are given")
{
  Shape_structure shape;
  shape.name = "table";
  shape.parts = quick_parts(table());
  shape.frame = frame_of(shape.parts);
  SECTION("nothing given: groups and contacts are detected")
  {
    const Structural_graph graph = complete_structural_graph(shape, {});
    CHECK(group_names(graph) == TABLE_GROUPS);
    CHECK(is_valid_structural_graph(graph, true));
  }
  SECTION("groups and a contact given")
  {
    std::vector<Part_group> groups(2);
    groups[0].parts = {0, 1, 2};
    groups[1].parts = {3, 4};
    shape.contacts = {{{0, 3}, {Eigen::Vector2d(0.5, 0), Eigen::Vector2d(1, 0)}, {}}};
    const Structural_graph graph = complete_structural_graph(shape, groups);
    CHECK(num_vertices(graph) == 2);
    CHECK(structure(graph).contacts.size() == 1);
  }
}

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hand_made_graphs.h"

#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <catch2/catch.hpp>

#include <limits>

using namespace hand_made;

namespace {

/// Two legs under a plate, with a brace between the legs: parts leg, plate, leg, brace; two contacts plate to legs, two
/// brace to legs, and one leg to leg.
Shape_structure trestle()
{
  Shape_structure shape;
  shape.name = "trestle";
  shape.parts = {curve("leg_1", {-1, 0, 0}, {-1, 1, 0}), sheet("plate", {-1, 1, -1}, {2, 0, 0}, {0, 0, 2}),
                 curve("leg_2", {1, 0, 0}, {1, 1, 0}), curve("brace", {-1, 0.5, 0}, {1, 0.5, 0})};
  for (const auto& pair : {std::array<std::size_t, 2>{0, 1}, {0, 2}, {0, 3}, {1, 2}, {2, 3}})
    shape.contacts.push_back({pair, {Eigen::Vector2d(0.5, 0), Eigen::Vector2d(0.5, 0)}, {}});
  return shape;
}

std::vector<Part_group> trestle_groups()
{
  return {group({3}), group({0, 2}, Symmetry_type::REFLECTION, {1, 0, 0}), group({1})};
}

} // namespace

TEST_CASE("Vertices are groups and edges are contacts")
{
  const Structural_graph graph = make_structural_graph(trestle(), trestle_groups());
  REQUIRE(num_vertices(graph) == 3);
  REQUIRE(num_edges(graph) == 2);
  CHECK(structure(graph).name == "trestle");
  CHECK(group_of_parts(graph) == std::vector<std::size_t>{1, 2, 1, 0});
  auto edge = edges(graph).first;
  CHECK(source(*edge, graph) == 0);
  CHECK(target(*edge, graph) == 1);
  CHECK(graph[*edge].contacts == std::vector<std::size_t>{2, 4});
  ++edge;
  CHECK(source(*edge, graph) == 1);
  CHECK(target(*edge, graph) == 2);
  CHECK(graph[*edge].contacts == std::vector<std::size_t>{0, 3});
  CHECK(is_valid_structural_graph(graph, true));
}

TEST_CASE("Invalid graphs are detected")
{
  const Structural_graph good = make_structural_graph(trestle(), trestle_groups());
  Structural_graph graph = good;
  SECTION("a part in two groups") { graph[0].parts.push_back(1); }
  SECTION("a part in no group") { graph[1].parts.pop_back(); }
  SECTION("a group without parts") { add_vertex(graph); }
  SECTION("a part that does not exist") { graph[0].parts[0] = 7; }
  SECTION("a number that is not finite") { graph[0].volume = std::numeric_limits<double>::quiet_NaN(); }
  SECTION("a point that is not finite")
  {
    std::get<Curve>(structure(graph).parts[0].geometry).points(0, 0) = std::numeric_limits<double>::infinity();
  }
  SECTION("an edge without contacts") { add_edge(0, 2, graph); }
  SECTION("a contact without an edge") { remove_edge(0, 1, graph); }
  SECTION("a contact that is not on its edge") { graph[*edges(graph).first].contacts.pop_back(); }
  SECTION("a contact of a part with itself") { structure(graph).contacts[1].parts = {2, 2}; }
  SECTION("a contact of a part that does not exist") { structure(graph).contacts[0].parts = {0, 9}; }
  SECTION("a frame without height") { structure(graph).frame.height = 0; }
  SECTION("a group that touches no other")
  {
    Shape_structure shape = trestle();
    shape.contacts.resize(2);
    graph = make_structural_graph(shape, trestle_groups());
  }
  CHECK_FALSE(is_valid_structural_graph(graph));
  CHECK(is_valid_structural_graph(good));
}

TEST_CASE("A graph of one group needs no edge")
{
  Shape_structure shape;
  shape.parts = {curve("a", {0, 0, 0}, {0, 1, 0}), curve("b", {1, 0, 0}, {1, 1, 0})};
  CHECK(is_valid_structural_graph(make_structural_graph(shape, {group({0, 1}, Symmetry_type::REFLECTION, {1, 0, 0})})));
}

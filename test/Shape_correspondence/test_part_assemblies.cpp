// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hand_made_graphs.h"
#include "matching/part_assemblies.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace CGAL::Shape_correspondence;

namespace {

using Indices = std::vector<std::size_t>;

Indices original(const Aligned_shape& shape, const Indices& parts)
{
  Indices result;
  for (std::size_t part : parts)
    result.push_back(shape.original[part]);
  std::sort(result.begin(), result.end());
  return result;
}

struct Assemblies
{
  std::vector<Indices> panels;
  Indices support, legs;
};

Assemblies assemblies(const Structural_graph& graph)
{
  const Aligned_shape shape = align_shape(graph);
  const Part_assemblies found = part_assemblies(shape);
  Assemblies result;
  for (const Indices& panel : found.panels)
    result.panels.push_back(original(shape, panel));
  result.support = original(shape, found.support);
  result.legs = original(shape, found.legs);
  return result;
}

Structural_graph with_parts(const Structural_graph& graph, const std::vector<Part_abstraction>& parts,
                            const std::vector<std::pair<std::array<std::size_t, 2>, Point>>& contacts)
{
  Shape_structure shape = structure(graph);
  std::vector<Part_group> groups;
  for (std::size_t v = 0; v < num_vertices(graph); ++v)
    groups.push_back(graph[v]);
  for (const Part_abstraction& part : parts) {
    groups.push_back(hand_made::group({shape.parts.size()}));
    shape.parts.push_back(part);
  }
  for (const auto& [pair, where] : contacts)
    shape.contacts.push_back(hand_made::contact(shape, pair[0], pair[1], where));
  return make_structural_graph(std::move(shape), std::move(groups));
}

// The slatted chair with a top rail (part 8), posts (9, 10), a bar (11) to the front, and a rail under the seat (12).
Structural_graph framed_chair()
{
  using hand_made::curve;
  return with_parts(hand_made::slatted_chair(),
                    {curve("rail", {-.25, 1, -.25}, {.25, 1, -.25}),
                     curve("post left", {.25, .5, -.25}, {.25, 1, -.25}),
                     curve("post right", {-.25, .5, -.25}, {-.25, 1, -.25}), curve("bar", {0, 1, -.25}, {0, 1, .25}),
                     curve("seat rail", {-.25, .45, -.25}, {.25, .45, -.25})},
                    {{{1, 8}, {-.2, 1, -.25}},
                     {{2, 8}, {0, 1, -.25}},
                     {{3, 8}, {.2, 1, -.25}},
                     {{8, 9}, {.25, 1, -.25}},
                     {{8, 10}, {-.25, 1, -.25}},
                     {{8, 11}, {0, 1, -.25}},
                     {{9, 12}, {.25, .5, -.25}},
                     {{0, 12}, {0, .5, -.25}}});
}

// The pedestal table with its column on a plate (part 2).
Structural_graph table_on_plate()
{
  Shape_structure shape = structure(hand_made::pedestal_table());
  shape.parts[1] = hand_made::curve("column", {0, .05, 0}, {0, 1, 0});
  shape.parts.push_back(hand_made::sheet("plate", {-.2, 0, -.2}, {.4, 0, 0}, {0, 0, .4}));
  shape.contacts = {hand_made::contact(shape, 0, 1, {0, 1, 0}), hand_made::contact(shape, 1, 2, {0, 0, 0})};
  return make_structural_graph(std::move(shape), {hand_made::group({0}), hand_made::group({1}), hand_made::group({2})});
}

} // namespace

TEST_CASE("The frame of a row consists of connected parts that lie in its plane and extend no further")
{
  const Assemblies found = assemblies(framed_chair());
  REQUIRE(found.panels.size() == 1);
  // The seat, the bar that leaves the plane, and the rail under the seat do not belong to it
  CHECK(found.panels[0] == Indices{1, 2, 3, 8, 9, 10});
}

TEST_CASE("A row without a frame is a panel by itself; groups that are no rows are no panels")
{
  CHECK(assemblies(hand_made::slatted_chair()).panels == std::vector<Indices>{{1, 2, 3}});
  CHECK(assemblies(hand_made::table()).panels.empty());
  CHECK(assemblies(hand_made::chair()).panels.empty());
}

TEST_CASE("A row is no frame of another")
{
  using hand_made::curve;
  // A chair with slats away from its sides, each with a knob
  const Structural_graph slats = hand_made::slatted_chair();
  Shape_structure shape = structure(slats);
  const std::vector<Part_group> groups = {slats[0], slats[1], slats[2], slats[3],
                                          hand_made::group({8, 9, 10}, Symmetry_type::TRANSLATION, {.15, 0, 0}, .4)};
  for (const std::size_t slat : {1, 2, 3}) {
    const double x = .15 * (double(slat) - 2); // away from the sides
    shape.parts[slat] = curve("slat", {x, .5, -.1}, {x, 1, -.1});
    shape.parts.push_back(curve("knob", {x, .7, -.1}, {x, .75, -.1}));
    shape.contacts.push_back(hand_made::contact(shape, slat, slat + 7, {x, .7, -.1}));
  }
  CHECK(assemblies(make_structural_graph(std::move(shape), groups)).panels ==
        std::vector<Indices>{{8, 9, 10}, {1, 2, 3}});
}

TEST_CASE("What lies flat in a side of a shape, above its main surface, is a panel")
{
  using hand_made::curve;
  // A bed: the table with a board and a rail (parts 5, 6) at one end, attached to posts on two of its legs (7, 8), a
  // rail (9) at the other end, one (10) under the mattress, and one (11) across its middle
  const Structural_graph bed =
      with_parts(hand_made::table(),
                 {hand_made::sheet("board", {-.5, 1.05, -.5}, {1, 0, 0}, {0, .3, 0}),
                  curve("rail", {-.5, 1.5, -.5}, {.5, 1.5, -.5}), curve("post", {-.5, 1, -.5}, {-.5, 1.5, -.5}),
                  curve("post", {.5, 1, -.5}, {.5, 1.5, -.5}), curve("foot rail", {-.5, 1.2, .5}, {.5, 1.2, .5}),
                  curve("low rail", {-.5, .8, -.5}, {.5, .8, -.5}), curve("middle rail", {-.5, 1.2, 0}, {.5, 1.2, 0})},
                 {{{1, 7}, {-.5, 1, -.5}},
                  {{2, 8}, {.5, 1, -.5}},
                  {{5, 7}, {-.5, 1.2, -.5}},
                  {{6, 8}, {.5, 1.5, -.5}},
                  {{1, 10}, {-.5, .8, -.5}},
                  {{5, 11}, {-.5, 1.2, 0}},
                  {{9, 11}, {.5, 1.2, .5}}});
  // Only the legs and the mattress, the main surface, connect 5 and 7 to 6 and 8, and the mattress joins no panels
  CHECK(assemblies(bed).panels == std::vector<Indices>{{5, 7}, {6, 8}});
}

TEST_CASE("A chain is made of like closed curves that touch one after the other")
{
  Shape_structure shape;
  shape.name = "lantern";
  std::vector<Part_group> groups;
  for (int k = 0; k < 4; ++k) {
    const Point across = k % 2 == 0 ? Point(.1, 0, 0) : Point(0, 0, .1);
    shape.parts.push_back(hand_made::ring("ring", {0, 1 + .18 * k, 0}, {0, .1, 0}, across));
  }
  shape.parts.push_back(hand_made::ring("rim", {0, 0, 0}, {.5, 0, 0}, {0, 0, .5})); // another size
  // A ring of similar size around the rim
  shape.parts.push_back(hand_made::ring("tyre", {0, 0, 0}, {.55, 0, 0}, {0, 0, .55}));
  shape.parts.push_back(hand_made::curve("rod", {0, 0, 0}, {0, .9, 0}));
  for (std::size_t k = 0; k + 1 < 4; ++k)
    shape.contacts.push_back(hand_made::contact(shape, k, k + 1, {0, 1.09 + .18 * double(k), 0}));
  for (const auto& [a, b] : {std::make_pair(0, 6), std::make_pair(4, 6), std::make_pair(4, 5)})
    shape.contacts.push_back(hand_made::contact(shape, std::size_t(a), std::size_t(b), {.5, 0, 0}));
  for (std::size_t k = 0; k < shape.parts.size(); ++k)
    groups.push_back(hand_made::group({k}));
  const auto rings = [&] {
    const Structural_graph graph = make_structural_graph(shape, groups);
    const Aligned_shape aligned = align_shape(graph);
    Indices found;
    for (std::size_t k = 0; k < aligned.parts.size(); ++k)
      if (part_assemblies(aligned).is_in_chain[k]) found.push_back(k);
    return original(aligned, found);
  };
  CHECK(rings() == Indices{0, 1, 2, 3});
  shape.contacts.erase(shape.contacts.begin()); // the first ring is no longer connected
  CHECK(rings() == Indices{1, 2, 3});
  shape.contacts.erase(shape.contacts.begin()); // two are not a chain, nor are rim and tyre
  CHECK(rings().empty());
}

TEST_CASE("Legs support the main surface, and so do parts that connect one of them to it")
{
  CHECK(assemblies(hand_made::chair()).support == Indices{2, 3, 4, 5});
  CHECK(assemblies(hand_made::table()).support == Indices{1, 2, 3, 4});
  CHECK(assemblies(hand_made::pedestal_table()).support == Indices{1});
  CHECK(assemblies(table_on_plate()).support == Indices{1, 2});
  // A stretcher between two legs supports nothing
  const Structural_graph table =
      with_parts(hand_made::table(), {hand_made::curve("stretcher", {-.5, .3, -.5}, {.5, .3, -.5})},
                 {{{1, 5}, {-.5, .3, -.5}}, {{2, 5}, {.5, .3, -.5}}});
  CHECK(assemblies(table).support == Indices{1, 2, 3, 4});
}

TEST_CASE("Wide parts on the ground are no legs where there are narrow ones")
{
  const Structural_graph panelled = with_parts(
      hand_made::table(), {hand_made::sheet("panel", {-.5, 0, -.5}, {1, 0, 0}, {0, 1, 0})}, {{{0, 5}, {0, 1, -.5}}});
  const Assemblies found = assemblies(panelled);
  CHECK(found.support == Indices{1, 2, 3, 4, 5});
  CHECK(found.legs == Indices{1, 2, 3, 4});

  Shape_structure shape = structure(hand_made::table());
  shape.parts.resize(1);
  shape.contacts.clear();
  for (double x : {-.5, .5}) {
    shape.parts.push_back(hand_made::sheet("side", {x, 0, -.5}, {0, 0, 1}, {0, 1, 0}));
    shape.contacts.push_back(hand_made::contact(shape, 0, shape.parts.size() - 1, {x, 1, 0}));
  }
  const Structural_graph on_panels =
      make_structural_graph(std::move(shape), {hand_made::group({0}), hand_made::group({1}), hand_made::group({2})});
  CHECK(assemblies(on_panels).legs == Indices{1, 2});
}

TEST_CASE("What has no main surface has no support")
{
  Shape_structure shape;
  shape.name = "posts";
  shape.parts = {hand_made::curve("post", {0, 0, 0}, {0, 1, 0}), hand_made::curve("beam", {0, 1, 0}, {1, 1, 0})};
  shape.contacts = {hand_made::contact(shape, 0, 1, {0, 1, 0})};
  const Assemblies found =
      assemblies(make_structural_graph(std::move(shape), {hand_made::group({0}), hand_made::group({1})}));
  CHECK(found.support.empty());
  CHECK(found.legs.empty());
}

TEST_CASE("Assemblies do not depend on position, scale and turning")
{
  const Structural_graph moved = hand_made::moved(framed_chair(), 0.6, 20, {7, 3, -4});
  CHECK(assemblies(moved).panels == assemblies(framed_chair()).panels);
  CHECK(assemblies(moved).support == assemblies(framed_chair()).support);
}

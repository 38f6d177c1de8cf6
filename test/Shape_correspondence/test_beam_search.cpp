// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "brute_force.h"
#include "hand_made_graphs.h"
#include "search/beam_search.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <catch2/catch.hpp>

using namespace CGAL::Shape_correspondence;
using namespace hand_made;

TEST_CASE("Beam search: complete, its energy is that of its assignment, and no lower than the bound")
{
  for (const bool symmetry : {true, false}) {
    const Matching_problem problem(align_shape(chair(symmetry)), align_shape(slatted_chair()));
    const Search_result result = beam_search(problem);
    for (int label : result.best().assignment)
      CHECK(label != unassigned);
    CHECK(result.best().energy == problem.energy()(result.best().assignment));
    CHECK(problem.energy().lower_bound() <= result.best().energy);
    CHECK(result.best().energy >= brute_force(problem.energy())[0] - 1e-9);
  }
}

TEST_CASE("A beam as wide as the tree finds the least energy")
{
  const Matching_problem problem(align_shape(chair()), align_shape(slatted_chair()));
  Beam_options wide;
  wide.beam_width = wide.expansions = 1000;
  CHECK(beam_search(problem, wide).best().energy == Approx(brute_force(problem.energy())[0]).margin(1e-6));
}

TEST_CASE("A self-match costs exactly nothing")
{
  for (const Structural_graph& graph : {chair(), chair(false), slatted_chair()}) {
    const Matching_problem problem(align_shape(graph), align_shape(graph));
    const Search_result result = beam_search(problem);
    CHECK(result.best().energy == 0);
    for (std::size_t g = 0; g < result.best().assignment.size(); ++g)
      CHECK(result.best().assignment[g] == int(g));
  }
}

TEST_CASE("Widths under one are refused")
{
  const Matching_problem problem(align_shape(chair()), align_shape(chair()));
  CHECK_THROWS_AS(beam_search(problem, {0, 4}), Invalid_input);
  CHECK_THROWS_AS(beam_search(problem, {20, 0}), Invalid_input);
}

TEST_CASE("The last level is returned in the order of its energies")
{
  const Matching_problem problem(align_shape(chair()), align_shape(slatted_chair()));
  const Search_result result = beam_search(problem);
  CHECK(result.solutions.size() == 20);
  for (std::size_t i = 0; i < result.solutions.size(); ++i) {
    CHECK(result.solutions[i].energy == problem.energy()(result.solutions[i].assignment));
    if (i > 0) CHECK(result.solutions[i - 1].energy <= result.solutions[i].energy + 1e-6);
  }
}

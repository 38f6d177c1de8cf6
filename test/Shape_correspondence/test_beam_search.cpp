// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/beam_search.h>

#include "brute_force.h"
#include "hand_made_graphs.h"

#include <catch2/catch.hpp>

using namespace CGAL::Shape_correspondence;
using namespace hand_made;

TEST_CASE("Beam search: complete, its energy is that of its assignment, and no lower than the bound")
{
  for (const bool symmetry : {true, false}) {
    const Matching_problem problem(align_shape(chair(symmetry)), align_shape(slatted_chair()), {});
    const Search_result result = beam_search(problem);
    for (int label : result.assignment)
      CHECK(label != unassigned);
    CHECK(result.energy == problem.energy(result.assignment));
    CHECK(problem.lower_bound() <= result.energy);
    CHECK(result.energy >= brute_force(problem));
  }
}

TEST_CASE("A beam as wide as the tree finds the least energy")
{
  const Matching_problem problem(align_shape(chair()), align_shape(slatted_chair()), {});
  Beam_options wide;
  wide.beam_width = wide.expansions = 1000;
  CHECK(beam_search(problem, wide).energy == Approx(brute_force(problem)).margin(1e-6));
}

TEST_CASE("A self-match costs exactly nothing")
{
  for (const Structural_graph& graph : {chair(), chair(false), slatted_chair()}) {
    const Matching_problem problem(align_shape(graph), align_shape(graph), {});
    const Search_result result = beam_search(problem);
    CHECK(result.energy == 0);
    for (std::size_t g = 0; g < result.assignment.size(); ++g)
      CHECK(result.assignment[g] == int(g));
  }
}

TEST_CASE("Widths under one are refused")
{
  const Matching_problem problem(align_shape(chair()), align_shape(chair()), {});
  CHECK_THROWS_AS(beam_search(problem, {0, 4}), Invalid_input);
  CHECK_THROWS_AS(beam_search(problem, {20, 0}), Invalid_input);
}

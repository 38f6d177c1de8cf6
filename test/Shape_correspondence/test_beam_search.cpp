// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/beam_search.h>

#include "hand_made_graphs.h"

#include <catch2/catch.hpp>

using namespace CGAL::Shape_correspondence;
using namespace hand_made;

namespace {

// All assignments, energy by energy.
double brute_force(const Matching_problem& problem)
{
  Assignment assignment(problem.source().groups.size(), 0);
  double best = problem.energy(assignment);
  for (std::size_t g = 0; g < assignment.size();) {
    if (++assignment[g] == int(problem.number_of_labels())) {
      assignment[g++] = 0;
      continue;
    }
    best = std::min(best, problem.energy(assignment));
    g = 0;
  }
  return best;
}

} // namespace

TEST_CASE("The tables add up to the energy of an assignment")
{
  const Matching_problem problem(align_shape(slatted_chair()), align_shape(chair()), {});
  Assignment assignment(problem.source().groups.size());
  for (std::size_t g = 0; g < assignment.size(); ++g)
    assignment[g] = int((g * 7 + 2) % problem.number_of_labels());
  double sum = 0;
  for (std::size_t g : problem.active_groups())
    sum += problem.unary_cost(g)[assignment[g]];
  for (const Matching_problem::Edge& edge : problem.edges())
    sum += edge.cost(assignment[edge.first], assignment[edge.second]);
  CHECK(problem.energy(assignment) == Approx(sum + problem.weights().split * problem.terms(assignment).split));
}

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

TEST_CASE("Coarse correspondence: the most prominent groups only")
{
  const Matching_problem problem(align_shape(chair()), align_shape(chair()), {}, 2);
  REQUIRE(problem.active_groups().size() == 2); // seat and back
  for (std::size_t g : problem.active_groups())
    CHECK(problem.source().groups[g].parts.size() == 1);
  CHECK(problem.active_contacts().size() == 1);
  CHECK(beam_search(problem).energy == 0);
}

TEST_CASE("Widths under one are refused")
{
  const Matching_problem problem(align_shape(chair()), align_shape(chair()), {});
  CHECK_THROWS_AS(beam_search(problem, {0, 4}), Invalid_input);
  CHECK_THROWS_AS(beam_search(problem, {20, 0}), Invalid_input);
}

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Shape_correspondence/Matching_problem.h>

#include "hand_made_graphs.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace CGAL::Shape_correspondence;
using namespace hand_made;

namespace {

// A row of vertical posts on the ground, each touching the next.
Structural_graph fence(int posts)
{
  Shape_structure shape;
  std::vector<Part_group> groups;
  for (int i = 0; i < posts; ++i) {
    shape.parts.push_back(curve("post " + std::to_string(i), {.1 * i, 0, 0}, {.1 * i, 1, 0}));
    groups.push_back(group({std::size_t(i)}));
    if (i > 0) shape.contacts.push_back(contact(shape, std::size_t(i - 1), std::size_t(i), {.1 * i, 1, 0}));
  }
  return make_structural_graph(std::move(shape), std::move(groups));
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

TEST_CASE("Coarse correspondence: the most prominent groups only")
{
  const Matching_problem problem(align_shape(chair()), align_shape(chair()), {}, 2);
  REQUIRE(problem.active_groups().size() == 2); // seat and back
  for (std::size_t g : problem.active_groups())
    CHECK(problem.source().groups[g].parts.size() == 1);
  CHECK(problem.active_contacts().size() == 1);
}

TEST_CASE("Both ends of a contact on one target part: the authors' charge for the connection")
{
  const Matching_problem problem(align_shape(chair(false)), align_shape(chair(false)), {});
  for (std::size_t contact : problem.active_contacts())
    for (std::size_t label = 0; label < problem.number_of_labels(); ++label)
      CHECK(problem.contact_energy(contact, label, label).connectedness == collapsed_connectedness);
}

TEST_CASE("A part that splits: the contact's energy is the mean over clones, each with its nearest counterpart")
{
  const Matching_problem problem(align_shape(chair()), align_shape(slatted_chair()), {});
  const Aligned_shape &source = problem.source(), &target = problem.target();
  const auto group_of = [](const Aligned_shape& shape, std::size_t original) {
    const auto part = std::find(shape.original.begin(), shape.original.end(), original) - shape.original.begin();
    return shape.group_of[std::size_t(part)];
  };
  const std::size_t seat = group_of(source, 0), back = group_of(source, 1);
  for (std::size_t contact : problem.active_contacts()) {
    const auto& parts = source.contacts[contact].parts;
    const std::size_t g = source.group_of[parts[0]], h = source.group_of[parts[1]];
    if (std::minmax(g, h) != std::minmax(seat, back)) continue;
    double sum = 0;
    for (std::size_t slat : {1, 2, 3}) {
      const std::size_t image =
          std::size_t(std::find(target.original.begin(), target.original.end(), slat) - target.original.begin());
      const std::size_t to_seat =
          std::size_t(std::find(target.original.begin(), target.original.end(), 0u) - target.original.begin());
      const Points &first = problem.deformed(parts[0], g == seat ? to_seat : image),
                   &second = problem.deformed(parts[1], g == seat ? image : to_seat);
      sum += problem.rods(contact, first.cols(), second.cols()).energy(first, second).distortion;
    }
    const std::size_t target_seat = group_of(target, 0), slats = group_of(target, 1);
    const Rod_energy energy =
        problem.contact_energy(contact, g == seat ? target_seat : slats, g == seat ? slats : target_seat);
    CHECK(energy.distortion == Approx(sum / 3));
  }
}

TEST_CASE("Many target groups: the nearest ones are the labels, and nothing is proven")
{
  const int posts = int(maximum_labels) + 16;
  const Matching_problem problem(align_shape(fence(5)), align_shape(fence(posts)), {});
  CHECK(problem.has_shortlists());
  CHECK(problem.number_of_labels() == maximum_labels);
  const std::size_t first = 0; // the leftmost post of either fence
  CHECK(problem.label(first, 0).target_group == first);
  CHECK(!Matching_problem(align_shape(fence(5)), align_shape(fence(5)), {}).has_shortlists());
}

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hand_made_graphs.h"
#include "matching/Part_costs.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace CGAL::Shape_correspondence;

namespace {

Eigen::MatrixXd part_costs(const Aligned_shape& source, const Aligned_shape& target,
                           const Part_matching_options& options = {})
{
  return part_costs(internal::Shape_features(source, options), internal::Shape_features(target, options), options);
}

constexpr Part_cost_weights no_weights{0, 0, 0, 0, 0, 0};

Eigen::Index aligned(const Aligned_shape& shape, std::size_t part)
{
  for (std::size_t i = 0; i < shape.original.size(); ++i)
    if (shape.original[i] == part) return Eigen::Index(i);
  FAIL("no such part");
  return 0;
}

// The cost of matching part a to part b of the same shape, if one term has weight 1 and all others 0.
double cost(const Structural_graph& graph, double Part_cost_weights::*weight, std::size_t a, std::size_t b)
{
  Part_matching_options options;
  options.weights = no_weights;
  options.weights.*weight = 1;
  options.anchor = 1;  // disables warping
  options.whole = 1e6; // so high that no part corresponds to a panel or an arrangement as a whole
  const Aligned_shape shape = align_shape(graph);
  return part_costs(shape, shape, options)(aligned(shape, a), aligned(shape, b));
}

} // namespace

TEST_CASE("Part costs by hand, in the unit box: a table of width 1 and height 1")
{
  const Structural_graph table = hand_made::table(); // 0: top; legs: 1 at (-, -), 2 at (+, -), 3 at (-, +), 4 at (+, +)
  using W = Part_cost_weights;

  CHECK(cost(table, &W::place, 1, 1) == Approx(0).margin(1e-12));
  CHECK(cost(table, &W::place, 1, 2) == Approx(1)); // apart in x
  CHECK(cost(table, &W::place, 1, 3) == Approx(1)); // apart in z
  CHECK(cost(table, &W::place, 1, 4) == Approx(2)); // apart in both
  CHECK(cost(table, &W::place, 0, 3) == Approx(1)); // half the distance in both axes

  CHECK(cost(table, &W::ground, 1, 2) == 0);
  CHECK(cost(table, &W::ground, 0, 2) == 1);

  // A leg is elongated in y, the top extends equally in x and z
  CHECK(cost(table, &W::orientation, 1, 2) == Approx(0).margin(1e-12));
  CHECK(cost(table, &W::orientation, 0, 1) == Approx(std::sqrt(2.)));

  // Extents 1 and 0 along each axis, padded by .03
  CHECK(cost(table, &W::extent, 1, 2) == Approx(0).margin(1e-12));
  CHECK(cost(table, &W::extent, 0, 1) == Approx(3 * std::log(1.03 / .03)));

  // Legs do not overlap; the upper end of each, padded by .03, overlaps the top
  CHECK(cost(table, &W::overlap, 1, 2) == Approx(1));
  CHECK(cost(table, &W::overlap, 1, 1) == Approx(0).margin(1e-12));
  CHECK(cost(table, &W::overlap, 0, 1) == Approx(1 - .03 / 1.03));

  CHECK(cost(table, &W::chamfer, 1, 2) == Approx(1));
  CHECK(cost(table, &W::chamfer, 1, 4) == Approx(std::sqrt(2.)));
}

TEST_CASE(
    "Part costs: that one part reaches the ground and the other does not costs half for boards as large as a wall")
{
  Shape_structure shape = structure(hand_made::table());
  shape.parts.push_back(hand_made::sheet("board", {-.5, 0, -.5}, {1, 0, 0}, {0, .8, 0}));
  shape.parts.push_back(hand_made::sheet("low board", {-.5, 0, .5}, {1, 0, 0}, {0, .6, 0}));
  shape.parts.push_back(hand_made::sheet("narrow board", {-.5, 0, 0}, {.6, 0, 0}, {0, .8, 0}));
  std::vector<Part_group> groups;
  for (std::size_t k = 0; k < shape.parts.size(); ++k)
    groups.push_back(hand_made::group({k}));
  const Structural_graph graph = make_structural_graph(std::move(shape), std::move(groups));
  CHECK(cost(graph, &Part_cost_weights::ground, 0, 5) == .5);
  CHECK(cost(graph, &Part_cost_weights::ground, 0, 6) == 1);
  CHECK(cost(graph, &Part_cost_weights::ground, 0, 7) == 1);
}

TEST_CASE("Part costs: with the shapes swapped, the transposed matrix, to the bit")
{
  const Aligned_shape a = align_shape(hand_made::chair()), b = align_shape(hand_made::slatted_chair());
  const Eigen::MatrixXd costs = part_costs(a, b);
  REQUIRE(costs.rows() == 6);
  REQUIRE(costs.cols() == 8);
  CHECK(costs == part_costs(b, a).transpose());
}

TEST_CASE("Part costs do not depend on position, scale and turning")
{
  const Structural_graph chair = hand_made::chair(), slats = hand_made::slatted_chair();
  const Eigen::MatrixXd costs = part_costs(align_shape(chair), align_shape(slats));
  const Structural_graph moved = hand_made::moved(slats, 0.4, 17, {3, -8, 100});
  CHECK((part_costs(align_shape(chair), align_shape(moved)) - costs).cwiseAbs().maxCoeff() < 1e-6);
}

TEST_CASE("Part costs: the unit box makes a stretched shape the same")
{
  Structural_graph wide = hand_made::table();
  for (Part_abstraction& part : structure(wide).parts)
    std::visit([](auto& geometry) { geometry.points.row(0) *= 3; }, part.geometry);
  const Aligned_shape table = align_shape(hand_made::table());
  CHECK((part_costs(table, align_shape(wide)) - part_costs(table, table)).cwiseAbs().maxCoeff() < 1e-9);
}

TEST_CASE("Part costs: the surface counts where it is known, the abstraction where not")
{
  Structural_graph thick = hand_made::table();
  Points surface(3, 2); // a leg ten times as wide at the same place
  surface << -.55, -.45, 0, 1, -.5, -.5;
  structure(thick).parts[1].surface = surface;
  using W = Part_cost_weights;
  CHECK(cost(thick, &W::extent, 1, 3) == Approx(std::log((.1 / 1.05 + .03) / .03)));
}

TEST_CASE("Part costs: four legs as one group resemble a pedestal more than each of them does")
{
  const Aligned_shape pedestal = align_shape(hand_made::pedestal_table());
  const auto leg_cost = [&](bool grouped) {
    const Aligned_shape table = align_shape(hand_made::table(grouped));
    return part_costs(table, pedestal)(aligned(table, 1), aligned(pedestal, 1));
  };
  CHECK(leg_cost(true) < leg_cost(false) - 1);
}

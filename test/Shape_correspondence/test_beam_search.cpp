// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "aligned_graphs.h"
#include "brute_force.h"
#include "search/Partial_energy.h"
#include "search/beam_search.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

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

// In the following cases, shapes consist of points (see `point_graph()`): those of the source are called a, b, c, those
// of the target 0, 1, 2. The weights are w_c = 0.6 and w_s = 0.4.

namespace {

// The best solution of a beam search. \param options beam width K and number of expansions k
Solution best(const Structural_graph& source, const Structural_graph& target, const Beam_options& options,
              const Energy_options& energy = {})
{
  return beam_search(Matching_problem(align_shape(source), align_shape(target), energy), options).best();
}

} // namespace

TEST_CASE("Local pruning: no partial solution takes all places of the beam")
{
  // Source point a has contacts with b, above it, and c, 2.6 away to its upper right. If a takes target point 0, b
  // costs nothing at the three points above 0, but c costs 8 / 13 or more: at these points, c's rod rotates by the
  // angle between (2.4, 1) and up, of cosine 5 / 13; at 5, it rotates and grows to 2.64, which costs 0.63. If a takes
  // 1, c costs nothing at 5, and b's best point, 4, is off by (0.3, 0.4), which costs 1 - 0.8
  const Structural_graph source = point_graph({{0, 0, 0}, {0, 1, 0}, {2.4, 1, 0}}, {{0, 1}, {0, 2}});
  const Structural_graph target = point_graph(
      {{0, 0, 0}, {-.3, .6, 0}, {0, .9, 0}, {0, .95, 0}, {0, 1, 0}, {2.1, 1.6, 0}}, {{0, 1}, {1, 2}, {2, 3}});
  const Matching_problem problem(align_shape(source), align_shape(target));
  // With k = 2, one of the K = 3 solutions in the beam has a at 1; with k = 3, all three have a at 0
  const Search_result balanced = beam_search(problem, {3, 2}), greedy = beam_search(problem, {3, 3});
  CHECK(balanced.best().assignment == Assignment{1, 4, 5});
  CHECK(balanced.best().energy == Approx(0.2));
  CHECK(greedy.best().assignment[0] == 0);
  CHECK(greedy.best().energy == Approx(8 / 13.));
  // Kept states: 2 at the first level, 3 of 2 * 2 and 3 of 3 * 2
  CHECK(balanced.summary.states == 8);
  CHECK(balanced.summary.evaluations == 6 + 2 * 6 + 3 * 6);
}

TEST_CASE("Groups are assigned from the best-connected one outwards")
{
  // A pair in the middle, with two contacts to a point below and two to one above; the target has another point far
  // below. With a beam of one, the first group takes its first label of least cost. If the lower point came first, all
  // labels would cost nothing, since all parts follow it, and it would take the lowest target point, from which the
  // pair is farther than before. For the pair, the target's pair costs nothing, and a single point rotates all rods
  const auto pair = [](std::size_t first) {
    return group({first, first + 1}, Symmetry_type::REFLECTION, Point::UnitX());
  };
  const Structural_graph source = point_graph({{0, 0, 0}, {-1, 1, 0}, {1, 1, 0}, {0, 2, 0}},
                                              {{0, 1}, {0, 2}, {1, 3}, {2, 3}}, {group({0}), pair(1), group({3})});
  const Structural_graph target =
      point_graph({{0, -5, 0}, {0, 0, 0}, {-1, 1, 0}, {1, 1, 0}, {0, 2, 0}}, {{1, 2}, {1, 3}, {2, 4}, {3, 4}},
                  {group({0}), group({1}), pair(2), group({4})});
  const Solution solution = best(source, target, {1, 1});
  CHECK(solution.assignment == Assignment{1, 2, 3});
  CHECK(solution.energy == Approx(0).margin(1e-6));
}

TEST_CASE("After the best-connected group come those in contact with it")
{
  // Points above each other, so that a rod costs nothing as long as it stays upright and does not grow. Source point a,
  // on the ground, has contacts with two leaves and with b above them, b with c, and c with two leaves above it. With a
  // beam of one, a, b and c take the lowest points, one above the other. If c, which has more contacts than b, came
  // second, it would take the point next to a, with no place for b in between
  const auto at = [](const std::vector<double>& heights) {
    std::vector<Point> places;
    for (double height : heights)
      places.emplace_back(0, height, 0);
    return places;
  };
  const Structural_graph source =
      point_graph(at({0, .3, .6, 1, 2, 3, 3.5}), {{0, 1}, {0, 2}, {0, 3}, {3, 4}, {4, 5}, {4, 6}});
  const Structural_graph target = point_graph(at({0, .1, .2, .3}), {{0, 1}, {1, 2}, {2, 3}});
  const Solution solution = best(source, target, {1, 1});
  CHECK(solution.assignment == Assignment{0, 1, 1, 1, 2, 3, 3});
  CHECK(solution.energy == Approx(0).margin(1e-6));
}

TEST_CASE("Parts not yet assigned move along")
{
  // In the source, b is above a; in the target, 2 is above 0. With a assigned to 0, b follows it at no cost; if b
  // stayed, its rod would rotate by an angle of cosine 0.8 and grow from 1 to 1.25, and 1, below b's old place, would
  // be better for a: with a there, b at 2 costs only 1 - 0.9 / 1.1715 = 0.23, and 0.6 for its distance
  const Structural_graph source = point_graph({{0, 0, 0}, {0, 1, 0}}, {{0, 1}});
  const Structural_graph target = point_graph({{.75, 0, 0}, {0, .1, 0}, {.75, 1, 0}}, {{0, 2}});
  const Solution solution = best(source, target, {1, 1});
  CHECK(solution.assignment == Assignment{0, 2});
  CHECK(solution.energy == Approx(0).margin(1e-6));
}

TEST_CASE("A part not yet assigned follows hard contacts to the point, and resists others")
{
  // A bar on two posts, one at its start and one between its ends; in the target, the second one is elsewhere
  const auto posts = [](double middle) {
    Shape_structure shape;
    shape.parts = {curve("bar", {0, 1, 0}, {1, 1, 0}), curve("start", {0, 0, 0}, {0, 1, 0}),
                   curve("middle", {middle, 0, 0}, {middle, 1, 0})};
    shape.contacts = {contact(shape, 0, 1, {0, 1, 0}), contact(shape, 0, 2, {middle, 1, 0})};
    return align_shape(make_structural_graph(std::move(shape), {group({0}), group({1}), group({2})}));
  };
  const Aligned_shape source = posts(.4), target = posts(.8);
  const auto moved_bar = [&](bool is_hard) {
    Energy_options options;
    options.hard_proximity = is_hard;
    const Matching_problem problem(source, target, options);
    internal::Partial_energy energy(problem);
    Assignment assignment(3, unassigned);
    for (std::size_t part : {1, 2}) {
      const internal::Rating parent = energy.rating();
      energy.set_parent(assignment, parent);
      const std::size_t group = source.group_of[index_of(source, part)];
      assignment[group] = int(target.group_of[index_of(target, part)]);
      energy(assignment, group, 0, std::numeric_limits<double>::infinity());
    }
    const auto& motion = energy.rating().motions[index_of(source, 0)];
    return (motion.shift + motion.stretch * Point(.4 - .5, 0, 0)).x(); // the point of the bar on the second post
  };
  const double displacement =
      target.parts[index_of(target, 2)].centroid.x() - source.parts[index_of(source, 2)].centroid.x();
  CHECK(moved_bar(true) == Approx(displacement).margin(1e-6));
  CHECK(std::abs(moved_bar(false) - displacement) > 1e-3);
}

TEST_CASE("The members of a group not yet assigned follow one of them by the group's generator")
{
  // A point with a pair to the left and right above it; in the target, all are higher by 0.2, and another point is on
  // the right, with the lowest label. If the point takes that label, at a displacement of 0.5, one of the pair follows
  // and the other moves to the left, so that its rod rotates by 45 degrees. If both followed, that would cost nothing
  for (const bool rotation : {true, false}) {
    const auto pair = [&](std::size_t first) {
      return rotation ? group({first, first + 1}, Symmetry_type::ROTATION, Point::UnitY())
                      : group({first, first + 1}, Symmetry_type::REFLECTION, Point::UnitX());
    };
    const Structural_graph source =
        point_graph({{0, 0, 0}, {-1, 1, 0}, {1, 1, 0}}, {{0, 1}, {0, 2}}, {group({0}), pair(1)});
    const Structural_graph target = point_graph({{.5, 0, 0}, {0, .2, 0}, {-1, 1.2, 0}, {1, 1.2, 0}}, {{1, 2}, {1, 3}},
                                                {group({0}), group({1}), pair(2)});
    const Solution solution = best(source, target, {1, 1});
    CHECK(solution.assignment == Assignment{1, 2});
    CHECK(solution.energy == Approx(0).margin(1e-6));
  }
}

TEST_CASE("Contacts of parts not yet assigned count")
{
  // A right angle with corners a, b, c, all in contact, assigned in this order. With a at 0, both 1 and 2 cost b
  // nothing. If b takes 1, half the way back, c is displaced by the mean of a's and b's displacements, a quarter to the
  // left, and its rods rotate. So b takes 2, and c stays in place; with b at 1, c's rod to b would rotate from (-1, 1)
  // to (-0.5, 1): 1 - 1.5 / sqrt(2 * 1.25) = 0.05
  const Structural_graph source = point_graph({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1}, {0, 2}, {1, 2}});
  const Structural_graph target = point_graph({{0, 0, 0}, {.5, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1}});
  const Solution solution = best(source, target, {1, 1});
  CHECK(solution.assignment == Assignment{0, 2, 3});
  CHECK(solution.energy == Approx(0).margin(1e-6));
}

TEST_CASE("Contacts between two parts not yet assigned count")
{
  // Points above each other: a at 0, d at 1.5, b at 2, c at 3, with contacts a - b - d - c - a; the target has another
  // point at 1. a is assigned first, to 0, then b. If b took 1 or 1.5, lower by s, no rod of a or b would grow, but d
  // would follow by 3 s / 4 and c by s / 4, and the rod between them would. So b takes 2, and d and c have points at no
  // cost. The target has no point within 0.5 below 1, which d would need if b took 1
  const Structural_graph source =
      point_graph({{0, 0, 0}, {0, 1.5, 0}, {0, 2, 0}, {0, 3, 0}}, {{0, 2}, {0, 3}, {1, 2}, {1, 3}});
  const Structural_graph target = point_graph({{0, 0, 0}, {0, 1, 0}, {0, 1.5, 0}, {0, 2, 0}, {0, 3, 0}}, {{0, 1}});
  const Solution solution = best(source, target, {1, 1});
  CHECK(solution.assignment == Assignment{0, 2, 3, 3});
  CHECK(solution.energy == Approx(0).margin(1e-6));
}

TEST_CASE("A part that pulls on one not yet assigned changes all contacts of that one")
{
  // A right angle with corners a, b, c, all in contact, assigned in this order; in the target it is half as large,
  // to the right. a takes 0, and c follows. If b takes 1, c is pulled half the way back: its rod to b rotates from (0,
  // 2) to (-0.5, 2), which costs 0.03, and grows, 0.6; the rod to a rotates by 0.01. If b takes 2, its rod to a rotates
  // by 45 degrees, 0.29, and the rod to c from (0, 2) to (-0.5, 1.5), 0.05, but c's rod to a grows as well: 0.6 and
  // 0.03
  const Structural_graph source = point_graph({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}}, {{0, 1}, {0, 2}, {1, 2}});
  const Structural_graph target = point_graph({{1, 0, 0}, {2, 0, 0}, {2, 1, 0}}, {{0, 1}, {0, 2}, {1, 2}});
  const Solution solution = best(source, target, {1, 1});
  CHECK(solution.assignment == Assignment{0, 1, 2});
  CHECK(solution.energy == Approx(0).margin(1e-6));
}

TEST_CASE("A part in contact with one that splits moves with the mean of the clones and touches the nearest one")
{
  // Three points above each other; in the target, the middle one is a pair, 0.3 lower and higher. The middle is
  // assigned first. If it takes the lowest point, or the pair, which leaves the others in place, each 0.7 from a clone,
  // no rod rotates or grows: a beam of two keeps both. With the lowest point, none is left below for the lowest part,
  // which costs at least 1; with the pair, each contact costs 0.6 for the farther clone, half of it in the mean
  const Structural_graph source = point_graph({{0, 0, 0}, {0, 1, 0}, {0, 2, 0}}, {{0, 1}, {1, 2}});
  const Structural_graph target =
      point_graph({{0, 0, 0}, {0, .7, 0}, {0, 1.3, 0}, {0, 2, 0}}, {{0, 1}, {1, 2}, {2, 3}},
                  {group({0}), group({1, 2}, Symmetry_type::TRANSLATION, {0, .6, 0}), group({3})});
  const Solution solution = best(source, target, {2, 2});
  CHECK(solution.assignment == Assignment{0, 1, 2});
  CHECK(solution.energy == Approx(2 * 0.6 / 2));
}

TEST_CASE("A part follows the point of contact with another part")
{
  // A post with a point 0.5 above it. The target has a post half as high with a point 0.4 above it, and next to it a
  // post of full height. If the point follows the top of the post, the lower post costs nothing and is taken, since it
  // has the lower label; if it followed the foot, 1 above the top, E_c would be 1 / 1.5
  const auto posts = [](const std::vector<double>& heights, const Point& above) {
    Shape_structure shape;
    std::vector<Part_group> groups;
    for (std::size_t i = 0; i < heights.size(); ++i)
      shape.parts.push_back(curve("post", {5. * double(i), 0, 0}, {5. * double(i), heights[i], 0}));
    shape.parts.push_back(curve("point", above, above));
    shape.contacts.push_back(contact(shape, 0, heights.size(), above));
    for (std::size_t i = 0; i < shape.parts.size(); ++i)
      groups.push_back(group({i}));
    return make_structural_graph(std::move(shape), std::move(groups));
  };
  const Solution solution = best(posts({1}, {0, 1.5, 0}), posts({.5, 1}, {0, .9, 0}), {1, 1});
  CHECK(solution.assignment == Assignment{0, 2});
  CHECK(solution.energy == Approx(0).margin(1e-6));
}

TEST_CASE("Contacts of a group left unmatched cost the charge for that, and no more")
{
  // A right angle with all three corners in contact; in the target, the right corner is half as far, and the upper one
  // is off by an angle of cosine 0.8. Matching all costs 0.2, and 0.01 for the rod between these two; leaving the upper
  // one unmatched costs 0.1 for each contact
  const Structural_graph source = point_graph({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1}, {0, 2}, {1, 2}});
  const Structural_graph target = point_graph({{0, 0, 0}, {.5, 0, 0}, {-.6, .8, 0}}, {{0, 1}, {0, 2}});
  Energy_options options;
  options.unmatched_cost = 0.1;
  const Solution solution = best(source, target, {100, 100}, options);
  CHECK(solution.energy == Approx(0.2));
  CHECK(solution.assignment == Assignment{0, 1, 3});
}

TEST_CASE("A part may split into a rotational group at no cost")
{
  // In the source, b is above a. In the target, two points are above 0, and one is off by an angle of cosine 0.96. A
  // solidity ratio of 0.1 would cost 0.4 (1 - sqrt((1 + 0.1 * 0.1) / 2)) = 0.116, more than the angle's 0.04
  const Structural_graph source = point_graph({{0, 0, 0}, {0, 1, 0}}, {{0, 1}});
  for (const bool rotational : {true, false}) {
    const Symmetry_type type = rotational ? Symmetry_type::ROTATION : Symmetry_type::TRANSLATION;
    const Structural_graph target = point_graph({{0, 0, 0}, {0, .4, 0}, {0, .8, 0}, {.28, .96, 0}}, {{0, 1}},
                                                {group({0}), group({1, 2}, type, Point::UnitZ(), .1), group({3})});
    const Solution solution = best(source, target, {});
    CHECK(solution.assignment == Assignment{0, rotational ? 1 : 2});
    CHECK(solution.energy == Approx(rotational ? 0 : 0.04).margin(1e-6));
  }
}

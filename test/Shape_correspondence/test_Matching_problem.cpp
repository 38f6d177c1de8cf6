// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "aligned_graphs.h"
#include "brute_force.h"
#include "deformed_parts.h"
#include "energy/Matching_problem.h"
#include "energy/Structural_rods.h"
#include "energy/cut_parts.h"
#include "search/beam_search.h"

#include <CGAL/Shape_correspondence/exact_search.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

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

TEST_CASE("The tables add up to the terms of an assignment, in both norms")
{
  for (const auto& [norm, fit] : {std::pair(Energy_norm::SUM, Deform_to_fit::SAMPLES),
                                  {Energy_norm::POOLED, Deform_to_fit::SAMPLES},
                                  {Energy_norm::SUM, Deform_to_fit::EXTREMITIES}}) {
    Energy_options options;
    options.norm = norm;
    options.fit = fit;
    options.weights.distortion = 0.7;
    options.unmatched_cost = 0.3;
    const Matching_problem problem(align_shape(slatted_chair()), align_shape(chair()), options);
    for (std::size_t start = 0; start < 5; ++start) {
      Assignment assignment(problem.source().number_of_groups());
      for (std::size_t g = 0; g < assignment.size(); ++g)
        assignment[g] = int((g * 7 + start) % problem.number_of_labels(g));
      const Energy_terms terms = problem.terms(assignment);
      CHECK(problem.energy()(assignment) == Approx(deformation_energy(terms, options.weights)));
    }
  }
}

TEST_CASE("Straight parts have the same energies by samples and by extremities")
{
  Energy_options options;
  const Matching_problem by_samples(align_shape(slatted_chair()), align_shape(chair()), options);
  options.fit = Deform_to_fit::EXTREMITIES;
  const Matching_problem by_extremities(align_shape(slatted_chair()), align_shape(chair()), options);
  for (std::size_t contact = 0; contact < by_samples.source().contacts.size(); ++contact) {
    const auto groups = by_samples.groups_of_contact(contact);
    for (std::size_t a = 0; a < by_samples.number_of_labels(groups[0]); ++a)
      for (std::size_t b = 0; b < by_samples.number_of_labels(groups[1]); ++b) {
        const Rod_energy one = by_samples.contact_energy(contact, a, b),
                         other = by_extremities.contact_energy(contact, a, b);
        CHECK(one.distortion == Approx(other.distortion).margin(1e-5));
        CHECK(one.connectedness == Approx(other.connectedness).margin(1e-5));
      }
  }
}

TEST_CASE("Role costs: each contact is charged the mean role cost of its two parts, as by brute force")
{
  const Aligned_shape source = align_shape(slatted_chair()), target = align_shape(chair());
  for (const Energy_norm norm : {Energy_norm::SUM, Energy_norm::POOLED}) {
    Energy_options options;
    options.norm = norm;
    options.unmatched_cost = 0.3;
    const Matching_problem without(source, target, options);
    options.role_costs.resize(Eigen::Index(source.parts.size()), Eigen::Index(target.parts.size()));
    for (Eigen::Index i = 0; i < options.role_costs.rows(); ++i)
      for (Eigen::Index j = 0; j < options.role_costs.cols(); ++j)
        options.role_costs(i, j) = double((3 * i + 5 * j) % 7) / 7;
    CHECK(Matching_problem(source, target, options).energy().unary == without.energy().unary); // roles weigh 0
    options.weights.roles = 0.8;
    const Matching_problem problem(source, target, options);
    const auto cost_of_part = [&](std::size_t part, const Assignment& assignment) {
      const std::size_t g = source.group_of[part];
      double sum = 0, count = 0;
      for (const auto& images : problem.label(g, std::size_t(assignment[g])).images)
        for (const Piece_image& image : images)
          if (image.source.part == part) {
            sum += options.role_costs(Eigen::Index(source.original[part]),
                                      Eigen::Index(target.original[image.target.part]));
            count += 1;
          }
      return count > 0 ? sum / count : 0;
    };
    for (std::size_t start = 0; start < 20; ++start) {
      Assignment assignment(problem.source().number_of_groups());
      for (std::size_t g = 0; g < assignment.size(); ++g)
        assignment[g] = int((g * 7 + start) % problem.number_of_labels(g));
      double expected = 0;
      for (const Sampled_contact& contact : source.contacts)
        expected += (cost_of_part(contact.parts[0], assignment) + cost_of_part(contact.parts[1], assignment)) / 2;
      if (norm == Energy_norm::POOLED) expected /= double(source.contacts.size());
      CHECK(problem.terms(assignment).roles == Approx(expected).margin(1e-12));
      CHECK(problem.energy()(assignment) == Approx(without.energy()(assignment) + 0.8 * expected));
      CHECK(problem.energy()(assignment) == Approx(deformation_energy(problem.terms(assignment), options.weights)));
    }
    const double least = brute_force(problem.energy())[0];
    CHECK(problem.energy().lower_bound() <= least);
    const Search_result exact = exact_search(problem.energy());
    CHECK(exact.optimal);
    CHECK(exact.best().energy == Approx(least).margin(1e-6));
    Beam_options wide;
    wide.beam_width = wide.expansions = 1000;
    CHECK(beam_search(problem, wide).best().energy == Approx(least).margin(1e-6));
    CHECK(internal::reversed(options).role_costs == options.role_costs.transpose());
  }
}

TEST_CASE("The pooled norm by hand: one norm over the rods of all contacts, the mean of E_c")
{
  Energy_options options;
  options.norm = Energy_norm::POOLED;
  const Matching_problem pooled(align_shape(chair()), align_shape(slatted_chair()), options);
  const Matching_problem sums(align_shape(chair()), align_shape(slatted_chair()));
  Assignment assignment(pooled.source().number_of_groups(), 0);
  double kept = 0, count = 0, connectedness = 0;
  for (std::size_t contact = 0; contact < sums.source().contacts.size(); ++contact) {
    const Rod_energy energy = sums.contact_energy(contact, 0, 0);
    const auto& parts = sums.source().contacts[contact].parts;
    const double rods =
        double(sums.source().parts[parts[0]].samples.cols() * sums.source().parts[parts[1]].samples.cols());
    kept += rods * std::pow(1 - energy.distortion, 2);
    count += rods;
    connectedness += energy.connectedness / double(sums.source().contacts.size());
  }
  CHECK(pooled.terms(assignment).distortion == Approx(1 - std::sqrt(kept / count)));
  CHECK(pooled.terms(assignment).connectedness == Approx(connectedness));
}

TEST_CASE("Coarse correspondence: the most prominent groups only")
{
  const Aligned_shape shape = align_shape(chair());
  const Matching_problem problem(restricted(shape, most_prominent_parts(shape, 2)), shape);
  REQUIRE(problem.source().number_of_groups() == 2); // seat and back remain
  for (const Part_group& group : groups(problem.source()))
    CHECK(group.parts.size() == 1);
  CHECK(problem.source().contacts.size() == 1);
}

TEST_CASE("A group left unmatched costs its contacts, or once without contacts")
{
  Energy_options options;
  options.unmatched_cost = 0.25;
  const Matching_problem problem(align_shape(chair()), align_shape(chair()), options);
  const Aligned_shape& shape = problem.source();
  for (std::size_t g = 0; g < shape.number_of_groups(); ++g) {
    Assignment assignment(shape.number_of_groups());
    for (std::size_t h = 0; h < assignment.size(); ++h)
      assignment[h] = int(h);
    assignment[g] = int(problem.number_of_labels(g)) - 1;
    REQUIRE(problem.is_unmatched(g, std::size_t(assignment[g])));
    const auto contacts = std::count_if(shape.contacts.begin(), shape.contacts.end(), [&](const Sampled_contact& c) {
      return shape.group_of[c.parts[0]] == g || shape.group_of[c.parts[1]] == g;
    });
    CHECK(problem.energy()(assignment) == Approx(0.25 * double(contacts)));
  }
  Shape_structure lone;
  lone.parts = {curve("a", {0, 0, 0}, {0, 1, 0})};
  const Aligned_shape post = align_shape(make_structural_graph(lone, {group({0})}));
  CHECK(Matching_problem(post, post, options).energy()({1}) == 0.25);
}

TEST_CASE("Two parts in contact that become one target part have the E_c of the authors' program for this case")
{
  const Matching_problem problem(align_shape(chair(false)), align_shape(chair(false)));
  for (std::size_t contact = 0; contact < problem.source().contacts.size(); ++contact)
    for (std::size_t label = 0; label < problem.target().number_of_groups(); ++label)
      CHECK(problem.contact_energy(contact, label, label).connectedness == collapsed_connectedness);
}

TEST_CASE("A sheet that splits: the contact's energy is the mean over its pieces, each with its counterpart")
{
  const Matching_problem problem(align_shape(chair()), align_shape(slatted_chair()));
  const Aligned_shape &source = problem.source(), &target = problem.target();
  const std::size_t seat = index_of(source, 0), back = index_of(source, 1);
  const std::size_t target_seat = target.group_of[index_of(target, 0)], slats = target.group_of[index_of(target, 1)];
  for (std::size_t contact = 0; contact < source.contacts.size(); ++contact) {
    const auto& parts = source.contacts[contact].parts;
    if (std::minmax(parts[0], parts[1]) != std::minmax(seat, back)) continue;
    // The slats are at -.2, 0 and .2 and equally wide: each gets a third of the back, from left to right
    const Sampled_part& sheet = source.parts[back];
    const bool along_u =
        std::abs(sheet.samples(0, samples_per_side * (samples_per_side - 1)) - sheet.samples(0, 0)) > .1;
    const bool from_left = sheet.samples(0, 0) < 0;
    const bool seat_first = parts[0] == seat;
    double sum = 0;
    for (int k : {0, 1, 2}) {
      std::array<double, 2> low{0, 0}, high{1, 1};
      low[along_u ? 0 : 1] = k / 3.;
      high[along_u ? 0 : 1] = (k + 1) / 3.;
      const Sampled_part piece = rectangle(sheet, low, high);
      const Points seat_now = deform_to_fit(source.parts[seat], target.parts[index_of(target, 0)]);
      const Points piece_now = deform_to_fit(piece, target.parts[index_of(target, from_left ? 1 + k : 3 - k)]);
      const Structural_rods rods = seat_first ? Structural_rods(source.parts[seat].samples, piece.samples)
                                              : Structural_rods(piece.samples, source.parts[seat].samples);
      sum += (seat_first ? rods.energy(seat_now, piece_now) : rods.energy(piece_now, seat_now)).distortion;
    }
    const Rod_energy energy =
        problem.contact_energy(contact, seat_first ? target_seat : slats, seat_first ? slats : target_seat);
    CHECK(energy.distortion == Approx(sum / 3));
  }
}

TEST_CASE("Two parts that split: every clone counts with its nearest counterpart, every pair once")
{
  // Of the target's points, 2 and 0 are nearest to each other, so are 4 and 1, and 0 is nearest to 3. The rod from 0 to
  // 3 turns by an angle of cosine 0.8; no rod is longer than the source's, 2
  const Structural_graph source = point_graph({{0, 0, 0}, {0, 2, 0}}, {{0, 1}});
  const Structural_graph target =
      point_graph({{0, 0, 0}, {10, 0, 0}, {0, 1, 0}, {.75, 1, 0}, {10, 2, 0}}, {{0, 2}, {0, 3}, {1, 4}},
                  {group({0, 1}, Symmetry_type::TRANSLATION), group({2, 3, 4}, Symmetry_type::TRANSLATION)});
  const Rod_energy energy = Matching_problem(align_shape(source), align_shape(target)).contact_energy(0, 0, 1);
  CHECK(energy.distortion == Approx((0 + 0 + 0.2) / 3));
  CHECK(energy.connectedness == 0);
}

TEST_CASE("A cut post costs nothing where the pieces stand on each other, and splitting it costs more")
{
  const auto post = [](int pieces) {
    Shape_structure shape;
    shape.parts.push_back(sheet("base", {-.2, 0, -.2}, {.4, 0, 0}, {0, 0, .4}));
    std::vector<std::size_t> members;
    for (int i = 0; i < pieces; ++i) {
      members.push_back(shape.parts.size());
      shape.parts.push_back(curve(std::to_string(i), {0, i / double(pieces), 0}, {0, (i + 1) / double(pieces), 0}));
      shape.contacts.push_back(contact(shape, members.back() - 1, members.back(), {0, i / double(pieces), 0}));
    }
    const Symmetry_type type = pieces == 1 ? Symmetry_type::SELF : Symmetry_type::TRANSLATION;
    return make_structural_graph(std::move(shape), {group({0}), group(members, type)});
  };
  const Aligned_shape whole = align_shape(post(1)), cut = align_shape(post(2));
  for (const bool forward : {true, false}) {
    const Matching_problem problem(forward ? whole : cut, forward ? cut : whole);
    const std::size_t base =
        problem.source().parts[problem.source().group(0).parts[0]].kind == Sampled_part::Kind::SHEET ? 0 : 1;
    const std::size_t posts = 1 - base, labels = problem.number_of_labels(posts);
    const Operation operation = problem.label(posts, labels - 1).operation;
    CHECK(operation == (forward ? Operation::CUT : Operation::JOIN));
    Assignment assignment(2);
    assignment[base] = int(base);
    assignment[posts] = int(labels) - 1;
    // The pieces are where the segments of the post are, so no rod rotates or grows
    CHECK(problem.terms(assignment).distortion == Approx(0).margin(1e-6));
    CHECK(problem.terms(assignment).connectedness == Approx(0).margin(1e-6));
    const double with_cut = problem.energy()(assignment);
    assignment[posts] = int(posts);
    CHECK(problem.energy()(assignment) > with_cut + 1e-3);
  }
}

TEST_CASE("A cut part: its contacts count by the segment that touches, and between segments there are rods")
{
  // A post on a base; in the target, its upper half lies flat, displaced sideways by 0.04 from the joint
  const auto shape_with = [](const std::vector<Part_abstraction>& curves) {
    Shape_structure shape;
    shape.parts.push_back(sheet("base", {-.2, 0, -.2}, {.4, 0, 0}, {0, 0, .4}));
    shape.parts.insert(shape.parts.end(), curves.begin(), curves.end());
    shape.contacts.push_back(contact(shape, 0, 1, {0, 0, 0}));
    std::vector<std::size_t> members;
    for (std::size_t i = 1; i < shape.parts.size(); ++i)
      members.push_back(i);
    return align_shape(make_structural_graph(std::move(shape), {group({0}), group(members)}));
  };
  const Part_abstraction low = curve("low", {0, 0, 0}, {0, .5, 0}), high = curve("high", {0, .5, 0}, {0, 1, 0}),
                         flat = curve("flat", {.04, .5, 0}, {.54, .5, 0});
  for (const bool upwards : {true, false}) {
    const Point ground(0, 0, 0), top(0, 1, 0);
    const Matching_problem problem(shape_with({upwards ? curve("post", ground, top) : curve("post", top, ground)}),
                                   shape_with({low, flat}));
    const std::size_t cut = problem.number_of_labels(1) - 1;
    REQUIRE(problem.label(1, cut).operation == Operation::CUT);
    CHECK(problem.contact_energy(0, 0, cut).distortion == Approx(0).margin(1e-6));
    CHECK(problem.contact_energy(0, 0, cut).connectedness == 0);
    const Structural_rods rods(sampled(low).samples, sampled(high).samples);
    const double distortion = rods.energy(sampled(low).samples, sampled(flat).samples).distortion;
    CHECK(distortion > 0.2);
    CHECK(problem.group_terms(1, cut).distortion == Approx(distortion).margin(1e-5));
    CHECK(problem.group_terms(1, cut).connectedness == Approx(0.04)); // Eq. 4: the gap over the longest rod, 1
  }
}

TEST_CASE("Of many target groups only the nearest ones are labels, and the problem says so")
{
  const std::size_t posts = maximum_labels + 16;
  const Aligned_shape few = align_shape(fence(5)), many = align_shape(fence(int(posts)));
  const Matching_problem problem(many, many);
  CHECK(problem.has_shortlists());
  for (const std::size_t post : {std::size_t(0), posts - 1}) { // leftmost and rightmost
    REQUIRE(problem.number_of_labels(post) == maximum_labels);
    for (std::size_t label = 0; label < maximum_labels; ++label)
      CHECK(problem.label(post, label).target_group == (post == 0 ? label : label + 16));
  }
  CHECK(!Matching_problem(few, few).has_shortlists());
}

TEST_CASE("A curve that is cut into three has rods between neighbouring segments only")
{
  // The target's curves form a stair, with steps of 0.3 to the side
  const auto shape_with = [](const std::vector<Part_abstraction>& curves) {
    Shape_structure shape;
    shape.parts = curves;
    std::vector<std::size_t> members;
    for (std::size_t i = 0; i < curves.size(); ++i)
      members.push_back(i);
    return align_shape(make_structural_graph(std::move(shape), {group(members)}));
  };
  const Part_abstraction first = curve("0", {0, 0, 0}, {1, 0, 0}), second = curve("1", {1, .3, 0}, {2, .3, 0}),
                         third = curve("2", {2, .6, 0}, {3, .6, 0}), whole = curve("whole", {0, 0, 0}, {3, 0, 0});
  const Matching_problem problem(shape_with({whole}), shape_with({first, second, third}));
  const std::size_t cut = problem.number_of_labels(0) - 1;
  REQUIRE(problem.label(0, cut).operation == Operation::CUT);
  const auto piece = [&](int i) { return segment(sampled(whole), i, 3).samples; };
  const Points moved = sampled(second).samples;
  const Rod_energy left = rod_energy(piece(0), piece(1), sampled(first).samples, moved),
                   right = rod_energy(piece(1), piece(2), moved, sampled(third).samples);
  CHECK(left.distortion > 0.05);
  CHECK(problem.group_terms(0, cut).distortion == Approx(left.distortion + right.distortion));
  CHECK(problem.group_terms(0, cut).connectedness == Approx(left.connectedness + right.connectedness));
}

TEST_CASE("Contacts inside a group are in the tables")
{
  const auto pair = [](double height) {
    return align_shape(point_graph({{0, 0, 0}, {1, height, 0}}, {{0, 1}}, {group({0, 1}, Symmetry_type::TRANSLATION)}));
  };
  const Matching_problem problem(pair(0), pair(1)); // the rod rotates by 45 degrees and grows
  CHECK(problem.energy()({0}) == Approx(1 - std::sqrt(.5) + 0.6));
}

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hand_made_graphs.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/build_structural_graph.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <type_traits>
#include <utility>

using namespace CGAL::Shape_correspondence;
using namespace hand_made;
using Pairs = Part_pairs;

namespace {

Search_options least_energy()
{
  Search_options options;
  options.method = Search_method::BEAM;
  return options;
}

} // namespace

TEST_CASE("A shape corresponds to itself, at no cost")
{
  const Correspondence c = find_correspondence(chair(), chair(), least_energy());
  CHECK(c.energy == 0);
  CHECK(c.complete);
  CHECK(part_pairs(c.pairs) == Pairs{{0, 0}, {1, 1}, {2, 2}, {3, 3}, {4, 4}, {5, 5}});
  CHECK(c.unmatched_source.empty());
  CHECK(c.unmatched_target.empty());
  CHECK(c.direction == Direction::SOURCE_TO_TARGET);
}

TEST_CASE("A back splits into slats, and slats merge into a back")
{
  const Pairs expected = {{0, 0}, {1, 1}, {1, 2}, {1, 3}, {2, 4}, {3, 5}, {4, 6}, {5, 7}};
  Search_options forward = least_energy();
  forward.both_directions = false;
  const Correspondence split = find_correspondence(chair(), slatted_chair(), forward);
  CHECK(part_pairs(split.pairs) == expected);
  CHECK(split.groups[1].operation == Operation::SPLIT);
  CHECK(split.groups[1].source == std::vector<std::size_t>{1});
  CHECK(split.groups[1].target == std::vector<std::size_t>{1, 2, 3});
  CHECK(split.terms.split > 0);

  const Correspondence merge = find_correspondence(slatted_chair(), chair(), forward);
  Pairs turned;
  for (const auto& pair : expected)
    turned.emplace_back(pair.second, pair.first);
  std::sort(turned.begin(), turned.end());
  CHECK(part_pairs(merge.pairs) == turned);
  CHECK(merge.groups[1].operation == Operation::MERGE);

  // Pairs stay (source, target), whichever direction is taken
  CHECK(part_pairs(find_correspondence(chair(), slatted_chair(), least_energy()).pairs) == expected);
  CHECK(part_pairs(find_correspondence(slatted_chair(), chair(), least_energy()).pairs) == turned);
}

TEST_CASE("A curve that is cut corresponds by its segments, in either direction")
{
  // A base, and a post of several pieces above each other
  const auto post = [](int pieces) {
    Shape_structure shape;
    shape.parts.push_back(sheet("base", {-.2, 0, -.2}, {.4, 0, 0}, {0, 0, .4}));
    std::vector<std::size_t> members;
    for (int i = 0; i < pieces; ++i) {
      const double low = i / double(pieces), high = (i + 1) / double(pieces);
      members.push_back(shape.parts.size());
      shape.parts.push_back(curve(std::to_string(i), {0, low, 0}, {0, high, 0}));
      shape.contacts.push_back(contact(shape, members.back() - 1, members.back(), {0, low, 0}));
    }
    const Symmetry_type type = pieces == 1 ? Symmetry_type::SELF : Symmetry_type::TRANSLATION;
    return make_structural_graph(std::move(shape), {group({0}), group(members, type)});
  };
  for (const bool both_directions : {false, true}) {
    Search_options options = least_energy();
    options.both_directions = both_directions;
    const Correspondence cut = find_correspondence(post(1), post(2), options);
    REQUIRE(part_pairs(cut.pairs) == Pairs{{0, 0}, {1, 1}, {1, 2}});
    CHECK(cut.pairs[0] == Part_correspondence{0, 0});
    for (int i : {0, 1}) {
      CHECK(cut.pairs[std::size_t(i) + 1].source_segment.count == 2);
      CHECK(cut.pairs[std::size_t(i) + 1].target_segment.is_whole_part());
    }
    CHECK(cut.pairs[1].source_segment.index != cut.pairs[2].source_segment.index);
    const Correspondence joined = find_correspondence(post(2), post(1), options);
    REQUIRE(joined.pairs.size() == cut.pairs.size());
    for (std::size_t k = 0; k < cut.pairs.size(); ++k)
      CHECK(inverse(joined.pairs[k]) == cut.pairs[k]);
  }
}

TEST_CASE("The terms of the energy add up")
{
  Search_options options = least_energy();
  options.both_directions = false;
  const Correspondence c = find_correspondence(table(), pedestal_table(), options); // legs merge
  CHECK(c.terms.distortion > 0.1);
  CHECK(c.energy == Approx(c.terms.distortion + 0.6 * c.terms.connectedness + 0.4 * c.terms.split));
  Energy_terms sum;
  for (const Contact_energy& contact : c.contacts) {
    sum.distortion += contact.distortion;
    sum.connectedness += contact.connectedness;
  }
  CHECK(sum.distortion == Approx(c.terms.distortion));
  CHECK(sum.connectedness == Approx(c.terms.connectedness));
  double groups = 0;
  std::vector<double> ratios;
  for (const Group_match& match : c.groups) {
    groups += match.energy;
    CHECK(match.energy == Approx(match.distortion + 0.6 * match.connectedness));
    ratios.push_back(match.solidity_ratio);
  }
  for (const Group_match& match : c.groups) { // each of the two groups of a contact has half of its energy
    double half = 0;
    for (const Contact_energy& contact : c.contacts)
      for (std::size_t part : contact.parts)
        half += std::count(match.source.begin(), match.source.end(), part) > 0 ? contact.distortion / 2 : 0;
    CHECK(match.distortion == Approx(half).margin(1e-12));
  }
  CHECK(split_energy(ratios) == Approx(c.terms.split));
  CHECK(groups == Approx(c.energy - 0.4 * c.terms.split));
  CHECK(c.search.lower_bound <= c.energy);
}

TEST_CASE("The shape that deforms at less energy per connected pair is deformed")
{
  // A point with another one 1 above it; a point with three others at a distance of 2, all off the up direction by an
  // angle of cosine 0.6. One rod that rotates and grows costs 0.4 + 0.6; the three rotate and shrink, which costs 3 *
  // 0.4 in total, but only 0.4 each
  const Structural_graph one = point_graph({{0, 0, 0}, {0, 1, 0}}, {{0, 1}});
  const Structural_graph three =
      point_graph({{0, 0, 0}, {-1.6, 1.2, 0}, {0, 1.2, 1.6}, {1.6, 1.2, 0}}, {{0, 1}, {0, 2}, {0, 3}});
  for (const Search_method method : {Search_method::BEAM, Search_method::EXACT}) {
    Search_options options;
    options.method = method;
    const Correspondence c = find_correspondence(one, three, options);
    CHECK(c.direction == Direction::TARGET_TO_SOURCE);
    CHECK(c.energy == Approx(1.2));
    CHECK(part_pairs(c.pairs) == Pairs{{0, 0}, {1, 1}, {1, 2}, {1, 3}});
    options.direction_by_energy = true; // as in the paper
    CHECK(find_correspondence(one, three, options).direction == Direction::SOURCE_TO_TARGET);
    CHECK(find_correspondence(one, three, options).energy == Approx(1));
    options.both_directions = false;
    CHECK(find_correspondence(one, three, options).energy == Approx(1));
    CHECK(find_correspondence(three, one, options).energy == Approx(1.2));
  }
}

TEST_CASE("If a group can become only some of many target groups, nothing is proven")
{
  std::vector<Point> row;
  for (int i = 0; i < 65; ++i)
    row.emplace_back(.1 * i, 0, 0);
  Search_options options;
  options.method = Search_method::EXACT;
  options.both_directions = false;
  const Structural_graph pair = point_graph({row[0], row[1]}, {{0, 1}});
  const Correspondence c = find_correspondence(pair, point_graph(row, {{0, 1}}), options);
  CHECK(!c.optimal);
  CHECK(c.warnings.size() == 1);
  row.pop_back();
  CHECK(find_correspondence(pair, point_graph(row, {{0, 1}}), options).optimal);
}

TEST_CASE("Moving, scaling and turning a shape changes no pair")
{
  const Pairs expected = part_pairs(find_correspondence(chair(), slatted_chair(), least_energy()).pairs);
  for (const double angle : {0.5236, -0.7, 0.2})
    for (const double scale : {0.01, 40.0}) {
      const Structural_graph turned = moved(slatted_chair(), angle, scale, {3, 100, -7});
      CHECK(part_pairs(find_correspondence(chair(), turned, least_energy()).pairs) == expected);
    }
}

TEST_CASE("A chair turned back to front is recognised when all alignments are tried")
{
  // A chair is given back to front, and its frame does not say so
  Structural_graph turned = moved(chair(), EIGEN_PI, 1, {0, 0, 0});
  structure(turned).frame.axes.setIdentity();
  Search_options all = least_energy();
  all.alignments = 0;
  const Correspondence c = find_correspondence(chair(), turned, all);
  CHECK(c.target_quarter_turns == 2);
  CHECK(c.energy == Approx(0).margin(1e-9));
  CHECK(part_pairs(c.pairs) == Pairs{{0, 0}, {1, 1}, {2, 2}, {3, 3}, {4, 4}, {5, 5}});
}

TEST_CASE("Coarse correspondence leaves the lesser parts out and says so")
{
  Search_options coarse = least_energy();
  coarse.maximum_parts = 2;
  const Correspondence c = find_correspondence(chair(), chair(), coarse);
  CHECK(part_pairs(c.pairs) == Pairs{{0, 0}, {1, 1}});
  CHECK(c.unmatched_source == std::vector<std::size_t>{2, 3, 4, 5});
}

TEST_CASE("The paper's method: beam search of all alignments, coarse in the source alone")
{
  const Search_options paper = paper_options();
  CHECK(paper.method == Search_method::BEAM);
  CHECK(paper.beam.beam_width == 20);
  CHECK(paper.beam.expansions == 4);
  CHECK(paper.direction_by_energy);
  CHECK(paper.energy.hard_proximity);
  CHECK(paper.energy.fit == Deform_to_fit::EXTREMITIES);

  Structural_graph turned = moved(chair(), EIGEN_PI, 1, {0, 0, 0});
  structure(turned).frame.axes.setIdentity();
  CHECK(find_correspondence(chair(), turned, paper).energy == Approx(0).margin(1e-9));

  // Seat and back are the most prominent parts of the source; all parts of the target can be matched
  Search_options coarse = paper;
  coarse.maximum_parts = 2;
  const Correspondence c = find_correspondence(chair(), slatted_chair(), coarse);
  CHECK(c.direction == Direction::SOURCE_TO_TARGET);
  CHECK(part_pairs(c.pairs) == Pairs{{0, 0}, {1, 1}, {1, 2}, {1, 3}});
  CHECK(c.unmatched_source == std::vector<std::size_t>{2, 3, 4, 5});
  int runs = 0;
  coarse.alignments = 1;
  coarse.progress = [&](double) { return ++runs > 0; };
  find_correspondence(chair(), slatted_chair(), coarse);
  CHECK(runs == 1);            // the whole target is not deformed into a coarse source
  coarse.coarse_target = true; // also takes two parts of the target: the seat and the first slat
  std::set<std::size_t> targets;
  for (const Part_correspondence& pair : find_correspondence(chair(), slatted_chair(), coarse).pairs)
    targets.insert(pair.target);
  CHECK(targets == std::set<std::size_t>{0, 1});
}

TEST_CASE("A group is merged into a part only if that is symmetric by itself, or if there is nothing else")
{
  Search_options options = least_energy();
  options.both_directions = false;
  const auto pedestal = [](Symmetry_type top, Symmetry_type column) {
    Structural_graph result = pedestal_table();
    result[0].symmetry.type = top;
    result[1].symmetry.type = column;
    return result;
  };
  const auto legs_become = [&](const Structural_graph& target) {
    const Correspondence c = find_correspondence(table(), target, options);
    CHECK(c.warnings.empty() ==
          (target[0].symmetry.type != target[1].symmetry.type || target[0].symmetry.type == Symmetry_type::SELF));
    return c.groups[1].target;
  };
  using Parts = std::vector<std::size_t>;
  CHECK(legs_become(pedestal(Symmetry_type::SELF, Symmetry_type::SELF)) == Parts{1});
  CHECK(legs_become(pedestal(Symmetry_type::NONE, Symmetry_type::SELF)) == Parts{1});
  CHECK(legs_become(pedestal(Symmetry_type::SELF, Symmetry_type::NONE)) == Parts{0});
  CHECK(legs_become(pedestal(Symmetry_type::NONE, Symmetry_type::NONE)) == Parts{1});
}

TEST_CASE("Options out of range are refused")
{
  Search_options options = least_energy();
  for (double weight : {-1., 1e51, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    options.energy.weights.split = weight;
    CHECK_THROWS_WITH(find_correspondence(chair(), chair(), options), Catch::Matchers::Contains("weights"));
  }
  options = {};
  options.alignments = -1;
  CHECK_THROWS_AS(find_correspondence(chair(), chair(), options), Invalid_input);
  options = least_energy();
  options.beam.beam_width = 0;
  CHECK_THROWS_AS(find_correspondence(chair(), chair(), options), Invalid_input);
}

TEST_CASE("A coarse correspondence is of the same parts in every alignment")
{
  // Equally prominent posts, so that positions decide which count as most prominent
  Shape_structure shape;
  shape.name = "posts";
  shape.parts = {curve("a", {-.6, 0, -.2}, {-.6, 1, -.2}), curve("b", {-.2, 0, .6}, {-.2, 1, .6}),
                 curve("c", {.2, 0, -.6}, {.2, 1, -.6}), curve("d", {.6, 0, .2}, {.6, 1, .2})};
  const Structural_graph posts = make_structural_graph(shape, {group({0}), group({1}), group({2}), group({3})});
  Shape_structure more = shape;
  more.frame.axes = Eigen::AngleAxisd(EIGEN_PI / 2, Point::UnitY()).toRotationMatrix();
  for (Part_abstraction& part : more.parts)
    std::get<Curve>(part.geometry).points.row(0) *= 0.9;
  more.parts.push_back(curve("e", {0, 0, 0}, {0, 1, 0}));
  const Structural_graph five =
      make_structural_graph(more, {group({0}), group({1}), group({2}), group({3}), group({4})});
  Search_options options;
  for (options.maximum_parts = 1; options.maximum_parts <= 4; ++options.maximum_parts) {
    INFO(options.maximum_parts);
    std::set<std::pair<std::size_t, std::size_t>> there, back;
    for (const Part_correspondence& pair : find_correspondence(posts, five, options).pairs)
      there.emplace(pair.source, pair.target);
    for (const Part_correspondence& pair : find_correspondence(five, posts, options).pairs)
      back.emplace(pair.target, pair.source);
    CHECK(!there.empty());
    CHECK(there == back);
  }
}

TEST_CASE("Only the chosen parts take part")
{
  Search_options options = least_energy();
  options.source_parts = {0, 2, 3};
  options.target_parts = {0, 4, 5};
  const Correspondence c = find_correspondence(chair(), chair(), options);
  CHECK(part_pairs(c.pairs) == Pairs{{0, 0}, {2, 4}, {3, 5}});
  CHECK(c.unmatched_source == std::vector<std::size_t>{1, 4, 5});
  options.source_parts = {17};
  CHECK_THROWS_AS(find_correspondence(chair(), chair(), options), Invalid_input);
}

TEST_CASE("Partial matching: what the other shape does not have stays unmatched where that is allowed")
{
  // A chair without its back, with the legs in place
  Structural_graph stool = chair();
  Shape_structure shape = structure(stool);
  shape.parts.erase(shape.parts.begin() + 1);
  std::vector<Contact> contacts;
  for (Contact contact : shape.contacts) {
    if (contact.parts[0] == 1 || contact.parts[1] == 1) continue;
    for (std::size_t& part : contact.parts)
      part -= part > 1;
    contacts.push_back(contact);
  }
  shape.contacts = contacts;
  const auto pair = Symmetry_type::REFLECTION;
  stool = make_structural_graph(
      shape, {group({0}), group({1, 2}, pair, Point::UnitX(), .1), group({3, 4}, pair, Point::UnitX(), .1)});
  for (const Search_method method : {Search_method::BEAM, Search_method::EXACT}) {
    Search_options options = least_energy();
    options.method = method;
    options.both_directions = false;
    options.energy.unmatched_cost = 0.1;
    const Correspondence c = find_correspondence(chair(), stool, options);
    CHECK(part_pairs(c.pairs) == Pairs{{0, 0}, {2, 1}, {3, 2}, {4, 3}, {5, 4}});
    CHECK(c.unmatched_source == std::vector<std::size_t>{1});
    CHECK(c.groups[1].operation == Operation::NONE);
    CHECK(c.terms.unmatched == Approx(0.1));
    CHECK(c.energy == Approx(0.1));
    options.energy.unmatched_cost = Energy_options::never;
    CHECK(find_correspondence(chair(), stool, options).unmatched_source.empty());
  }
}

TEST_CASE("Ranked correspondences: ascending, different, the first is the result")
{
  Search_options options = least_energy();
  options.method = Search_method::EXACT;
  options.solutions = 5;
  const Structural_graph source = chair();
  const auto ranked = Correspondence_finder(source, options).ranked(slatted_chair());
  REQUIRE(ranked.size() == 5);
  CHECK(ranked[0].pairs == find_correspondence(chair(), slatted_chair(), options).pairs);
  for (std::size_t i = 1; i < ranked.size(); ++i) {
    CHECK(ranked[i - 1].energy <= ranked[i].energy + 1e-9);
    CHECK(ranked[i].optimal);
  }
}

TEST_CASE("Min-marginals tell how sure a match is")
{
  Search_options options = least_energy();
  options.method = Search_method::EXACT;
  options.min_marginals = true;
  options.both_directions = false;
  const Correspondence c = find_correspondence(chair(), chair(), options);
  for (const Group_match& match : c.groups) {
    CHECK(match.min_marginal > 0.01); // a match of a shape with itself is unambiguous
    CHECK(match.min_marginal < 10);
  }
  options.min_marginals = false;
  CHECK(std::isnan(find_correspondence(chair(), chair(), options).groups[0].min_marginal));
}

TEST_CASE("A finder gives what the function gives")
{
  const Structural_graph source = chair();
  const Correspondence_finder find(source, least_energy());
  for (const Structural_graph& target : {chair(), slatted_chair(), chair(false)}) {
    const Correspondence found = find(target), expected = find_correspondence(chair(), target, least_energy());
    CHECK(found.pairs == expected.pairs);
    CHECK(found.energy == expected.energy);
  }
}

TEST_CASE("Classes that keep a graph by reference take no temporary graph")
{
  STATIC_REQUIRE(std::is_constructible_v<Prepared_shape, const Structural_graph&>);
  STATIC_REQUIRE(std::is_constructible_v<Correspondence_finder, const Structural_graph&>);
  STATIC_REQUIRE(!std::is_constructible_v<Prepared_shape, Structural_graph>);
  STATIC_REQUIRE(!std::is_constructible_v<Correspondence_finder, Structural_graph>);
  STATIC_REQUIRE(!std::is_constructible_v<Correspondence_finder, Structural_graph, Search_options>);
}

TEST_CASE("A cancelled search says so")
{
  Search_options options = least_energy();
  std::vector<double> done;
  options.progress = [&](double share) {
    done.push_back(share);
    return done.size() < 2;
  };
  const Correspondence c = find_correspondence(chair(), slatted_chair(), options);
  CHECK(done == std::vector<double>{0, 0.5});
  CHECK(!c.complete);
  CHECK(!c.pairs.empty()); // the forward direction was completed
  CHECK(c.warnings.size() == 1);
  options.progress = [](double) { return false; };
  for (const Search_method method : {Search_method::PARTS, Search_method::BEAM}) {
    options.method = method;
    const Correspondence none = find_correspondence(chair(), slatted_chair(), options);
    CHECK(!none.complete);
    CHECK(none.pairs.empty());
    CHECK(none.unmatched_source.size() == 6);
    CHECK(none.warnings.size() == 1);
  }
}

TEST_CASE("A term that is switched off has no effect")
{
  Search_options options = least_energy();
  options.energy.weights.connectedness = options.energy.weights.split = 0;
  const Correspondence c = find_correspondence(chair(), slatted_chair(), options);
  CHECK(c.energy == Approx(c.terms.distortion));
}

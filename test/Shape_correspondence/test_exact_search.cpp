// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/quantized.h"
#include "brute_force.h"
#include "hand_made_graphs.h"
#include "random_tables.h"
#include "search/Local_energy.h"
#include "search/Tangents.h"
#include "search/beam_search.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/exact_search.h>

#include <catch2/catch.hpp>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <new>
#include <random>
#include <string>
#include <type_traits>

using namespace CGAL::Shape_correspondence;

// The search keeps the energy by reference, so a temporary is refused
static_assert(!std::is_constructible_v<Exact_search, Pairwise_energy>);

using namespace hand_made;

// Counts all allocations of the program. If free() were inlined, g++ would warn of a mismatch with malloc()
static std::size_t allocations = 0;

void* operator new(std::size_t size)
{
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace {

// Random curves and sheets, random contacts, random groups of one or two parts with random solidity.
Structural_graph random_graph(std::mt19937& random, std::size_t group_count)
{
  std::uniform_real_distribution<double> unit(0, 1);
  const auto point = [&] { return Point(unit(random) - .5, unit(random), unit(random) - .5); };
  Shape_structure shape;
  std::vector<Part_group> groups;
  for (std::size_t g = 0; g < group_count; ++g) {
    std::vector<std::size_t> members;
    for (int i = unit(random) < .5 ? 0 : 1; i < 2; ++i) {
      members.push_back(shape.parts.size());
      const std::string name = std::to_string(shape.parts.size());
      if (unit(random) < .7)
        shape.parts.push_back(curve(name, point(), point()));
      else
        shape.parts.push_back(sheet(name, point(), point(), point()));
    }
    groups.push_back(group(members, Symmetry_type::TRANSLATION, Point::UnitX(), .1 + .9 * unit(random)));
  }
  for (std::size_t a = 0; a < shape.parts.size(); ++a)
    for (std::size_t b = a + 1; b < shape.parts.size(); ++b)
      if (b == a + 1 || unit(random) < .25) shape.contacts.push_back(contact(shape, a, b, point()));
  return make_structural_graph(std::move(shape), std::move(groups));
}

} // namespace

TEST_CASE("Exact search equals brute force on 1000 random problems, and is never above the beam")
{
  std::mt19937 random(1);
  for (int i = 0; i < 1000; ++i) {
    Energy_options options;
    if (i % 3 == 0) options.weights.split = 5;
    if (i % 4 == 0) options.norm = Energy_norm::POOLED;
    if (i % 5 == 0) options.unmatched_cost = 0.2;
    const Matching_problem problem(align_shape(random_graph(random, 3)), align_shape(random_graph(random, 4)), options);
    const Search_result exact = exact_search(problem.energy());
    CHECK(exact.optimal);
    CHECK(exact.best().energy == problem.energy()(exact.best().assignment));
    CHECK(exact.best().energy == Approx(brute_force(problem.energy())[0]).margin(1e-9));
    CHECK(exact.summary.lower_bound == exact.best().energy);
    if (i % 10 == 0) CHECK(exact.best().energy <= beam_search(problem).best().energy + 1e-9);
  }
}

TEST_CASE("The best solutions are the ones that brute force ranks first")
{
  std::mt19937 random(4);
  for (int i = 0; i < 50; ++i) {
    const Pairwise_energy energy = random_tables(random, 5, 4, 2);
    Exact_options options;
    options.solutions = 7;
    const Search_result result = exact_search(energy, options);
    const std::vector<double> all = brute_force(energy);
    REQUIRE(result.solutions.size() == 7);
    for (std::size_t k = 0; k < 7; ++k)
      CHECK(result.solutions[k].energy == Approx(all[k]).margin(1e-9));
  }
  Exact_options none;
  none.solutions = 0;
  CHECK_THROWS_AS(exact_search(random_tables(random, 3, 3, 1), none), Invalid_input);
}

TEST_CASE("Min-marginals are the rises to the least energy without the label, as by brute force")
{
  std::mt19937 random(5);
  for (int i = 0; i < 50; ++i) {
    const Pairwise_energy energy = random_tables(random, 5, 3, 2);
    Exact_search search(energy);
    const Search_result result = search.run();
    const std::vector<double> rises = search.min_marginals(result);
    for (std::size_t v = 0; v < 5; ++v) {
      const auto others = brute_force(energy, [&](const Assignment& a) { return a[v] != result.best().assignment[v]; });
      CHECK(rises[v] == Approx(others[0] - result.best().energy).margin(1e-9));
    }
  }
}

TEST_CASE("The cost of changing one label is the difference of the energies")
{
  std::mt19937 random(6);
  for (int i = 0; i < 50; ++i) {
    Pairwise_energy energy = random_tables(random, 6, 3, 2);
    energy.root_terms.push_back(energy.root_terms[0]);
    for (const Pairwise_energy::Edge& edge : energy.edges) // a root term of edges, like a pooled E_d
      energy.root_terms.back().edge.push_back(edge.cost / 4);
    Assignment assignment(6);
    for (int& label : assignment)
      label = int(random() % 3);
    const std::size_t v = random() % 6;
    const std::vector<double> rises = internal::Local_energy(energy).rises(v, assignment);
    const double before = energy(assignment);
    REQUIRE(rises.size() == 3);
    for (int label = 0; label < 3; ++label) {
      assignment[v] = label;
      CHECK(rises[std::size_t(label)] == Approx(energy(assignment) - before).margin(1e-12));
    }
  }
}

TEST_CASE("Split buckets bound from below and the search still finds the optimum")
{
  std::mt19937 random(2);
  for (int i = 0; i < 20; ++i) {
    const Pairwise_energy energy = random_tables(random, 9, 4, 4);
    Exact_options small;
    small.table_limit = 16; // limits tables to pairs of variables
    const Search_result result = exact_search(energy, small);
    CHECK(result.optimal);
    CHECK(result.best().energy == Approx(exact_search(energy).best().energy).margin(1e-9));
  }
}

TEST_CASE("Message passing moves costs, no assignment's energy changes, and the bound rises")
{
  std::mt19937 random(6);
  const Pairwise_energy energy = random_tables(random, 8, 4, 3);
  std::vector<Eigen::VectorXd> unary = energy.unary;
  std::vector<internal::Pair_cost> pairs;
  for (const Pairwise_energy::Edge& edge : energy.edges)
    pairs.push_back({edge.first, edge.second, edge.cost});
  const auto sum = [&](const Assignment& a) {
    double result = 0;
    for (std::size_t v = 0; v < unary.size(); ++v)
      result += unary[v][a[v]];
    for (const internal::Pair_cost& pair : pairs)
      result += pair.cost(a[pair.first], a[pair.second]);
    return result;
  };
  const auto bound = [&] {
    double result = 0;
    for (const Eigen::VectorXd& costs : unary)
      result += costs.minCoeff();
    for (const internal::Pair_cost& pair : pairs)
      result += pair.cost.minCoeff();
    return result;
  };
  const Assignment a{0, 1, 2, 3, 0, 1, 2, 3}, b{3, 3, 1, 0, 2, 2, 1, 0};
  const double before_a = sum(a), before_b = sum(b), bound_before = bound();
  internal::Message_passing pass_messages;
  pass_messages(unary, pairs, 20);
  CHECK(sum(a) == Approx(before_a));
  CHECK(sum(b) == Approx(before_b));
  CHECK(bound() > bound_before);

  // The same problem again continues from the last messages
  const double bound_after = bound();
  unary = energy.unary;
  for (std::size_t e = 0; e < pairs.size(); ++e)
    pairs[e].cost = energy.edges[e].cost;
  pass_messages(unary, pairs, 1);
  CHECK(sum(a) == Approx(before_a));
  CHECK(bound() > bound_after - 1e-3);
}

TEST_CASE("The node limit ends the search with a gap, not with a wrong proof")
{
  std::mt19937 random(3);
  const Pairwise_energy energy = random_tables(random, 12, 6, 5);
  Exact_options few;
  few.node_limit = 20;
  few.table_limit = 6;
  const Search_result result = exact_search(energy, few), best = exact_search(energy);
  CHECK(!result.optimal);
  CHECK(result.summary.lower_bound <= best.best().energy);
  CHECK(result.best().energy >= best.best().energy - 1e-9);
  CHECK(result.best().energy == energy(result.best().assignment));
  few.node_limit = Exact_options().node_limit;
  few.time_limit = 1e-9;
  few.table_limit = 1;
  CHECK(!exact_search(random_tables(random, 30, 8, 8), few).optimal);
}

TEST_CASE("A long search continues with larger tables, until its result is proven")
{
  // Tables of three variables exceed the first limit of the search. With smaller ones, millions of nodes give no proof
  std::mt19937 random(10);
  const Pairwise_energy energy = random_tables(random, 40, 40, 2);
  const Search_result result = exact_search(energy);
  CHECK(result.optimal);
  CHECK(result.best().energy == energy(result.best().assignment));
  Exact_options large;
  large.table_limit = 40 * 40 * 40;
  CHECK(result.best().energy == Approx(exact_search(energy, large).best().energy).margin(1e-9));

  // The nodes of all restarts are counted
  Exact_options few;
  few.node_limit = 70'000;
  few.table_limit = 1;
  const Search_result stopped = exact_search(random_tables(random, 30, 8, 8), few);
  CHECK(!stopped.optimal);
  CHECK(stopped.summary.states == few.node_limit);
}

TEST_CASE("Costs beyond the comparison grid are compared as its last step")
{
  constexpr double infinite = std::numeric_limits<double>::infinity();
  CHECK(internal::quantized(1e12) < internal::quantized(1e15));
  CHECK(internal::quantized(1e15) == internal::quantized(infinite));
  CHECK(internal::quantized(-infinite) == -internal::quantized(infinite));
  Energy_options options;
  options.unmatched_cost = 1e15; // beyond the last step of the grid of `quantized()`
  const Matching_problem problem(align_shape(chair()), align_shape(slatted_chair()), options),
      never(align_shape(chair()), align_shape(slatted_chair()));
  const Search_result result = exact_search(problem.energy()), expected = exact_search(never.energy());
  CHECK(result.best().assignment == expected.best().assignment);
  CHECK(result.summary.states == expected.summary.states);
}

TEST_CASE("A self-match is proven to cost nothing")
{
  const Matching_problem problem(align_shape(slatted_chair()), align_shape(slatted_chair()));
  const Search_result result = exact_search(problem.energy());
  CHECK(result.best().energy == 0);
  CHECK(result.optimal);
}

TEST_CASE("The search tree is walked without allocating")
{
  std::mt19937 random(8);
  const Pairwise_energy energy = random_tables(random, 14, 6, 5);
  Exact_options options;
  options.table_limit = 36; // gives a weak bound and a large tree
  Exact_search search(energy, options);
  allocations = 0;
  const Search_result result = search.run();
  CHECK(result.optimal);
  CHECK(result.summary.states > 2000);
  CHECK(allocations < 50);
}

namespace {

// Writes the sum of terms as a cost function network in toulbar2's CFN format, with six decimals.
void write_cfn(std::ostream& out, const Pairwise_energy& energy)
{
  out.precision(6);
  out << std::fixed << R"({"problem": {"name": "energy", "mustbe": "<1000.000000"}, "variables": {)";
  for (std::size_t v = 0; v < energy.number_of_variables(); ++v)
    out << (v ? ", " : "") << "\"v" << v << "\": " << energy.number_of_labels(v);
  out << "}, \"functions\": {";
  for (std::size_t v = 0; v < energy.number_of_variables(); ++v) {
    out << (v ? ", " : "") << "\"u" << v << R"(": {"scope": ["v)" << v << "\"], \"costs\": [";
    for (Eigen::Index l = 0; l < energy.unary[v].size(); ++l)
      out << (l ? ", " : "") << energy.unary[v][l];
    out << "]}";
  }
  for (std::size_t e = 0; e < energy.edges.size(); ++e) {
    const Pairwise_energy::Edge& edge = energy.edges[e];
    out << ", \"e" << e << R"(": {"scope": ["v)" << edge.first << "\", \"v" << edge.second << "\"], \"costs\": [";
    for (Eigen::Index a = 0; a < edge.cost.rows(); ++a)
      for (Eigen::Index b = 0; b < edge.cost.cols(); ++b)
        out << (a || b ? ", " : "") << edge.cost(a, b);
    out << "]}";
  }
  out << "}}\n";
}

} // namespace

TEST_CASE("An independent solver agrees, where it is installed")
{
  if (std::system("command -v toulbar2 > /dev/null 2>&1") != 0) {
    WARN("toulbar2 is not installed; skipped");
    return;
  }
  std::mt19937 random(9);
  for (int i = 0; i < 10; ++i) {
    Pairwise_energy energy = random_tables(random, 14, 5, 3);
    energy.root_terms.clear(); // toulbar2 supports sums only
    const std::string file = "toulbar2_test.cfn", log = "toulbar2_test.log";
    {
      std::ofstream out(file);
      write_cfn(out, energy);
    }
    REQUIRE(std::system(("toulbar2 " + file + " > " + log + " 2>&1").c_str()) == 0);
    std::ifstream in(log);
    double optimum = -1;
    for (std::string line; std::getline(in, line);)
      if (line.rfind("Optimum: ", 0) == 0) optimum = std::stod(line.substr(9));
    CHECK(exact_search(energy).best().energy == Approx(optimum).margin(1e-4));
    std::remove(file.c_str());
    std::remove(log.c_str());
  }
}

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

// Times the search on pairs of saved structural graphs, single-threaded: matching by parts; tables of energies, exact
// search and the paper's beam search, each in both directions. Prints medians and 95th percentiles in milliseconds, the
// energy of the beam over that of exact search, the speed of the rod kernel, and times of synthetic problems.
//   benchmark_search [--pairs] [--repeats N] GRAPH.json GRAPH.json ...     matches all pairs of graphs of one folder
// --pairs prints a line for each pair: numbers of parts, milliseconds of matching by parts, exact and beam search.
// --repeats: each pair is matched N times, and the least time counts, as other programs lengthen the other times.
#include "energy/Structural_rods.h"
#include "energy/rod_kernel.h"
#include "matching/match_parts.h"
#include "search/beam_search.h"

#include <CGAL/Shape_correspondence/IO/structural_graph_json.h>
#include <CGAL/Shape_correspondence/exact_search.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <limits>
#include <memory>
#include <random>
#include <string>

namespace SC = CGAL::Shape_correspondence;

namespace {

double milliseconds(const std::function<void()>& work)
{
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

double quantile(std::vector<double> values, double share)
{
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[std::min(values.size() - 1, std::size_t(share * double(values.size())))];
}

void print(const char* what, const std::vector<double>& values)
{
  std::printf("%-34s median %9.3f   95 %% %9.3f   most %9.3f\n", what, quantile(values, 0.5), quantile(values, 0.95),
              quantile(values, 1));
}

// The speed of the kernel that compares two sets of rods on sheets: rods per nanosecond, the best of many runs.
double kernel_speed()
{
  std::srand(1);
  const SC::internal::Sample_lanes first(SC::Points::Random(3, 36)), second(SC::Points::Random(3, 36));
  std::vector<SC::internal::Rod_block> rods(36 * SC::internal::maximum_blocks);
  for (SC::internal::Rod_block& block : rods)
    for (auto& axis : block.direction)
      std::fill(std::begin(axis), std::end(axis), 1.0f);
  const SC::internal::Rod_block* const sets[2] = {rods.data(), rods.data()};
  constexpr int repeats = 200, runs = 50;
  double best = 1e9, sum = 0;
  for (int run = 0; run < runs; ++run)
    best = std::min(best, milliseconds([&] {
                      for (int i = 0; i < repeats; ++i)
                        sum +=
                            double(SC::internal::compare_rods_of_two(sets, first, 36, second, 36).squared_cosines[0]);
                    }));
  return sum > 0 ? 2 * 36 * 36 * repeats / (best * 1e6) : 0;
}

// The energy of matching random points in the unit cube. A rod joins every source point to each of the `width` points
// before it; it costs the energy of moving its ends to two target points, which are the labels. Splits cost at random.
SC::Pairwise_energy synthetic_problem(unsigned seed, int groups, int labels, int width)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  const auto points = [&](int count) {
    return SC::Points(SC::Points::NullaryExpr(3, count, [&] { return unit(random); }));
  };
  const SC::Points source = points(groups), target = points(labels);
  SC::Pairwise_energy energy;
  SC::Pairwise_energy::Root_term split{SC::Energy_weights().split, double(groups), {}, {}};
  for (int v = 0; v < groups; ++v) {
    energy.unary.push_back(Eigen::VectorXd::Zero(labels));
    split.unary.push_back(Eigen::VectorXd::NullaryExpr(labels, [&] { return unit(random); }));
    for (int u = std::max(0, v - width); u < v; ++u) {
      Eigen::MatrixXd cost(labels, labels);
      for (int a = 0; a < labels; ++a)
        for (int b = 0; b < labels; ++b) {
          const SC::Structural_rods rod(source.col(u), source.col(v));
          const SC::Rod_energy e = rod.energy(target.col(a), target.col(b));
          cost(a, b) = e.distortion + SC::Energy_weights().connectedness * e.connectedness;
        }
      energy.edges.push_back({std::size_t(u), std::size_t(v), cost});
    }
  }
  energy.root_terms.push_back(split);
  return energy;
}

void print_synthetic_problems(int groups, int labels, int width)
{
  std::vector<double> times;
  std::size_t proven = 0;
  constexpr unsigned problems = 20;
  for (unsigned seed = 0; seed < problems; ++seed) {
    const SC::Pairwise_energy energy = synthetic_problem(seed, groups, labels, width);
    times.push_back(milliseconds([&] { proven += SC::exact_search(energy).optimal; }));
  }
  const std::string size = std::to_string(groups) + " groups x " + std::to_string(labels) + " labels";
  print((size + ", width " + std::to_string(width)).c_str(), times);
  std::printf("proven optimal: %zu of %u\n", proven, problems);
}

// Milliseconds of the phases for one pair, and the quality of what the searches found.
struct Pair_times
{
  double alignment = infinity, parts = infinity, tables = infinity, exact = infinity, tables_and_exact = infinity,
         tables_and_beam = infinity;
  std::vector<double> gaps; // ratio of the energy of beam search to that of exact search, by direction
  std::size_t proven = 0, at_optimum = 0;

  static constexpr double infinity = std::numeric_limits<double>::infinity();
};

void keep_least(double& least, double value) { least = std::min(least, value); }

Pair_times time_pair(const SC::Structural_graph& first, const SC::Structural_graph& second, int repeats)
{
  Pair_times result;
  for (int repeat = 0; repeat < repeats; ++repeat) {
    double align = 0, tables = 0, exact = 0, beam = 0;
    const SC::Aligned_shape first_shape = SC::align_shape(first), second_shape = SC::align_shape(second);
    keep_least(result.parts, milliseconds([&] { SC::match_parts(first_shape, second_shape); }));
    result.gaps.clear();
    result.proven = result.at_optimum = 0;
    for (const bool forward : {true, false}) {
      SC::Matching_problem::Shared_shape from, to; // new in every repeat, since shapes cache their rods
      align += milliseconds([&] {
        from = std::make_shared<SC::Deformable_shape>(SC::align_shape(forward ? first : second));
        to = std::make_shared<SC::Deformable_shape>(SC::align_shape(forward ? second : first));
      });
      std::unique_ptr<SC::Matching_problem> problem;
      tables += milliseconds([&] { problem = std::make_unique<SC::Matching_problem>(from, to); });
      SC::Search_result exact_result, beam_result;
      exact += milliseconds([&] { exact_result = SC::exact_search(problem->energy()); });
      beam += milliseconds([&] { beam_result = SC::beam_search(*problem); });
      const double least = exact_result.best().energy, found = beam_result.best().energy;
      result.proven += exact_result.optimal;
      result.at_optimum += found <= least + 1e-9;
      if (least > 0) result.gaps.push_back(found / least);
    }
    keep_least(result.alignment, align);
    keep_least(result.tables, tables);
    keep_least(result.exact, exact);
    keep_least(result.tables_and_exact, tables + exact);
    keep_least(result.tables_and_beam, tables + beam);
  }
  return result;
}

} // namespace

int main(int argc, char** argv)
{
  bool print_pairs = false;
  int repeats = 1;
  std::vector<std::string> files;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--pairs")
      print_pairs = true;
    else if (argument == "--repeats" && i + 1 < argc)
      repeats = std::max(1, std::atoi(argv[++i]));
    else
      files.push_back(argument);
  }
  if (files.size() < 2) {
    std::cerr << "usage: benchmark_search [--pairs] [--repeats N] GRAPH.json GRAPH.json ...\n";
    return 2;
  }
  std::vector<SC::Structural_graph> graphs;
  for (const std::string& file : files) {
    std::ifstream in(file);
    try {
      graphs.push_back(SC::IO::read_structural_graph_json(in, file));
    } catch (const SC::Invalid_input& error) {
      std::cerr << error.what() << '\n';
      return 1;
    }
  }
  const auto folder = [&](std::size_t graph) { return std::filesystem::path(files[graph]).parent_path(); };

  std::vector<double> align, parts, tables, exact, both, beam, gap;
  std::size_t proven = 0, at_optimum = 0;
  for (std::size_t i = 0; i < graphs.size(); ++i)
    for (std::size_t j = i + 1; j < graphs.size(); ++j) {
      if (folder(i) != folder(j)) continue;
      const Pair_times times = time_pair(graphs[i], graphs[j], repeats);
      align.push_back(times.alignment), parts.push_back(times.parts), tables.push_back(times.tables),
          exact.push_back(times.exact), both.push_back(times.tables_and_exact), beam.push_back(times.tables_and_beam);
      gap.insert(gap.end(), times.gaps.begin(), times.gaps.end());
      proven += times.proven;
      at_optimum += times.at_optimum;
      if (print_pairs)
        std::printf("pair %zu %zu %.4f %.4f %.4f\n", structure(graphs[i]).parts.size(),
                    structure(graphs[j]).parts.size(), parts.back(), both.back(), beam.back());
    }
  if (print_pairs) return 0;

  std::printf("%zu pairs of %zu graphs, both directions; milliseconds a pair\n", align.size(), graphs.size());
  print("alignment", align);
  print("matching by parts", parts);
  print("tables", tables);
  print("exact search", exact);
  print("tables and exact search", both);
  print("tables and beam (K = 20, k = 4)", beam);
  print("energy, beam over exact", gap);
  std::printf("proven optimal: %zu of %zu; beam at the optimum: %zu\n", proven, 2 * align.size(), at_optimum);
  std::printf("rod kernel: %.2f rods a nanosecond\n", kernel_speed());
  print_synthetic_problems(22, 20, 5);
  print_synthetic_problems(100, int(SC::maximum_labels), 2);
}

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Times the search on pairs of saved structural graphs, single-threaded: tables and exact search, and the paper's beam,
// each with both directions. Prints medians and 95th percentiles in milliseconds, and how far the beam is from the
// optimum.
//   benchmark_search GRAPH.json GRAPH.json ...     all pairs of the graphs given
#include <CGAL/Shape_correspondence/IO/structural_graph_json.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <functional>
#include <iostream>
#include <memory>

namespace SC = CGAL::Shape_correspondence;

namespace {

double milliseconds(const std::function<void()>& work)
{
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

// The value under which a share of the sample lies.
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

} // namespace

int main(int argc, char** argv)
{
  if (argc < 3) {
    std::cerr << "usage: benchmark_search GRAPH.json GRAPH.json ...\n";
    return 2;
  }
  std::vector<SC::Structural_graph> graphs;
  for (int i = 1; i < argc; ++i) {
    std::ifstream in(argv[i]);
    try {
      graphs.push_back(SC::IO::read_structural_graph_json(in, argv[i]));
    } catch (const SC::Invalid_input& error) {
      std::cerr << error.what() << '\n';
      return 1;
    }
  }

  std::vector<double> align, tables, exact, beam, gap;
  std::size_t proven = 0, at_optimum = 0, runs = 0;
  for (std::size_t i = 0; i < graphs.size(); ++i)
    for (std::size_t j = i + 1; j < graphs.size(); ++j) {
      double align_time = 0, tables_time = 0, exact_time = 0, beam_time = 0;
      for (const bool forward : {true, false}) {
        const SC::Structural_graph &a = graphs[forward ? i : j], &b = graphs[forward ? j : i];
        SC::Aligned_shape from, to;
        align_time += milliseconds([&] { from = SC::align_shape(a), to = SC::align_shape(b); });
        std::unique_ptr<SC::Matching_problem> problem;
        tables_time +=
            milliseconds([&] { problem = std::make_unique<SC::Matching_problem>(from, to); });
        SC::Search_result exact_result, beam_result;
        exact_time += milliseconds([&] { exact_result = SC::exact_search(problem->energy()); });
        beam_time += milliseconds([&] { beam_result = SC::beam_search(*problem); });
        ++runs;
        proven += exact_result.optimal;
        const double least = exact_result.best().energy, found = beam_result.best().energy;
        at_optimum += found <= least + 1e-9;
        if (least > 0) gap.push_back(found / least);
      }
      align.push_back(align_time), tables.push_back(tables_time), exact.push_back(exact_time),
          beam.push_back(beam_time);
    }

  std::printf("%zu pairs of %zu graphs, both directions; milliseconds a pair\n", align.size(), graphs.size());
  print("alignment", align);
  print("tables", tables);
  print("exact search", exact);
  print("beam search (K = 20, k = 4)", beam);
  print("energy, beam over exact", gap);
  std::printf("proven optimal: %zu of %zu; beam at the optimum: %zu\n", proven, runs, at_optimum);
}

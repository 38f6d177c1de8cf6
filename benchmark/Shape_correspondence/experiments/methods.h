// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "dataset.h"
#include "intervals.h"

#include <CGAL/Shape_correspondence/Part_map.h>
#include <CGAL/Shape_correspondence/co_analysis.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <chrono>
#include <cstdio>
#include <iostream>

namespace CGAL::Shape_correspondence::experiments {

inline double now()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// The method of this package with some options. An incomplete result counts as one without pairs.
inline peers::Peer ours(const Search_options& options)
{
  return [options](const std::vector<Structural_graph>& shapes, const std::vector<peers::Shape_pair>& pairs) {
    std::vector<Part_pairs> result;
    for (const auto& [s, t] : pairs) {
      const Correspondence c = find_correspondence(shapes[s], shapes[t], options);
      result.push_back(c.complete ? part_pairs(c.pairs) : Part_pairs{});
    }
    return result;
  };
}

/// A method applied to shapes without symmetry groups: every part is a group of its own.
inline peers::Peer without_symmetry(const peers::Peer& method)
{
  return [method](const std::vector<Structural_graph>& shapes, const std::vector<peers::Shape_pair>& pairs) {
    std::vector<Structural_graph> apart;
    for (const Structural_graph& graph : shapes) {
      std::vector<Part_group> groups;
      for (std::size_t i = 0; i < structure(graph).parts.size(); ++i)
        groups.push_back({{i}, {}, structure(graph).parts[i].volume, structure(graph).parts[i].hull_volume});
      apart.push_back(make_structural_graph(structure(graph), groups));
    }
    return method(apart, pairs);
  };
}

/// A method's maps of all pairs of a collection, made consistent by `co_analysis()`: parts with one label correspond.
template <typename Map>
peers::Peer co_analyzed(const Map& map, const Co_analysis_options& options = {})
{
  return [map, options](const std::vector<Structural_graph>& shapes, const std::vector<peers::Shape_pair>& pairs) {
    std::vector<std::size_t> counts;
    std::vector<Shape_pair_map> maps;
    for (std::size_t s = 0; s < shapes.size(); ++s) {
      counts.push_back(structure(shapes[s]).parts.size());
      for (std::size_t t = 0; t < s; ++t)
        maps.push_back({t, s, map(shapes[t], shapes[s])});
    }
    const Co_analysis analysis = co_analysis(counts, maps, options);
    std::vector<Part_pairs> result;
    for (const auto& [s, t] : pairs) {
      result.emplace_back();
      for (std::size_t i = 0; i < counts[s]; ++i)
        for (std::size_t j = 0; j < counts[t]; ++j)
          if (analysis.labels[s][i] != Co_analysis::none && analysis.labels[s][i] == analysis.labels[t][j])
            result.back().emplace_back(i, j);
    }
    return result;
  };
}

inline Search_options default_options() { return {}; }

/// Exact search. If the proof takes more than `nodes` search nodes, the best result so far is taken.
inline Search_options exact_options()
{
  constexpr std::size_t nodes = 20000;
  Search_options options;
  options.method = Search_method::EXACT;
  options.exact.node_limit = nodes;
  return options;
}

/// The correspondences of a method on a dataset, and their scores.
struct Run
{
  std::vector<std::vector<Part_pairs>> matches; ///< by category and pair of shapes
  std::vector<Scored_correspondence> scores;    ///< of all pairs, category after category
  Estimated_scores evaluation;
  double seconds = 0; ///< mean wall-clock time of a pair
};

inline std::vector<Scored_correspondence> score(const Category& category, const std::vector<Part_pairs>& matches)
{
  std::vector<Scored_correspondence> result;
  for (std::size_t k = 0; k < matches.size(); ++k) {
    const auto [s, t] = category.pairs[k];
    const Ground_truth truth = ground_truth(category.labels[s], category.labels[t]);
    result.push_back(
        {category.name, category.shapes[s], category.shapes[t], evaluate_correspondence(matches[k], truth)});
  }
  return result;
}

inline Run run(const Dataset& dataset, const peers::Peer& method)
{
  Run result;
  const double begin = now();
  for (const Category& category : dataset)
    result.matches.push_back(method(category.graphs, category.pairs));
  const double seconds = now() - begin;
  for (std::size_t c = 0; c < dataset.size(); ++c)
    for (const Scored_correspondence& scored : score(dataset[c], result.matches[c]))
      result.scores.push_back(scored);
  result.evaluation = mean_estimates(result.scores);
  result.seconds = seconds / double(result.scores.size());
  return result;
}

/// A number in decimal notation, with `digits` digits after the point.
inline std::string text(double number, int digits = 3)
{
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.*f", digits, number);
  return buffer;
}

/// Prints a row of a Markdown table.
inline void write_row(const std::vector<std::string>& cells)
{
  for (const std::string& cell : cells)
    std::cout << "| " << cell << ' ';
  std::cout << "|\n";
}

inline void write_heading(const std::vector<std::string>& cells)
{
  write_row(cells);
  for (std::size_t i = 0; i < cells.size(); ++i)
    std::cout << "|---";
  std::cout << "|\n";
}

inline void write_run_heading(const Dataset& dataset, const std::string& what)
{
  std::vector<std::string> cells{what};
  for (const Category& category : dataset)
    cells.push_back(category.name + " P / R / F1");
  for (const char* cell : {"mean P", "mean R", "mean F1", "95 %", "s / pair"})
    cells.push_back(cell);
  write_heading(cells);
}

inline void write_run_row(const std::string& name, const Run& run)
{
  std::vector<std::string> cells{name};
  for (const auto& [category, mean] : run.evaluation.categories)
    cells.push_back(text(mean.precision.mean, 2) + " / " + text(mean.recall.mean, 2) + " / " + text(mean.f1.mean, 2));
  const Mean_estimates& mean = run.evaluation.mean;
  for (const Estimate& e : {mean.precision, mean.recall, mean.f1})
    cells.push_back(text(e.mean));
  cells.push_back(text(mean.f1.low, 2) + "–" + text(mean.f1.high, 2));
  cells.push_back(text(run.seconds, 4));
  write_row(cells);
}

} // namespace CGAL::Shape_correspondence::experiments

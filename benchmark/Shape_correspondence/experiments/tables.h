// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

// The paper's Tables 2 and 3, a comparison of all methods, and the reliability of confidences.
#pragma once

#include "../peers/peers.h"
#include "chart.h"
#include "methods.h"
#include "options.h"

#include <utility>

namespace CGAL::Shape_correspondence::experiments {

inline void compare(const Dataset& dataset, const std::vector<std::pair<std::string, peers::Peer>>& methods,
                    const std::string& what = "method")
{
  write_run_heading(dataset, what);
  for (const auto& [name, method] : methods)
    write_run_row(name, run(dataset, method));
}

/// Share of the pairs of parts with equal coarse labels that is found: mean over pairs of shapes, then over categories.
inline double coarse_recall(const Dataset& dataset, const Run& run)
{
  double sum = 0;
  for (std::size_t c = 0; c < dataset.size(); ++c) {
    double of_category = 0;
    for (std::size_t k = 0; k < dataset[c].pairs.size(); ++k) {
      const auto [s, t] = dataset[c].pairs[k];
      Ground_truth truth = ground_truth(dataset[c].labels[s], dataset[c].labels[t]);
      truth.pairs = truth.coarse_pairs;
      of_category += evaluate_correspondence(run.matches[c][k], truth).recall();
    }
    sum += of_category / double(dataset[c].pairs.size());
  }
  return sum / double(dataset.size());
}

inline void table2(const Dataset& dataset)
{
  const auto ours_by = [](const Search_options& options, const Co_analysis_options& co_analysis = {}) {
    return co_analyzed(
        [options](const Structural_graph& source, const Structural_graph& target) {
          return part_map(find_correspondence(source, target, options));
        },
        co_analysis);
  };
  Co_analysis_options all_pairs; // rejects no pair of parts as an outlier, as in the paper
  all_pairs.least_cycle_support = 0;
  const auto xu = co_analyzed([](const Structural_graph& source, const Structural_graph& target) {
    const auto [a, b] = peers::boxed_pair(source, target);
    Part_map result;
    for (const auto& [i, j] : peers::match_xu_2012(a, b))
      result.pairs.push_back({i, j, 1});
    return result;
  });
  std::vector<std::string> heading{"method"};
  for (const Category& category : dataset)
    heading.push_back(category.name);
  heading.insert(heading.end(), {"mean coarse P", "95 %", "mean coarse R"});
  write_heading(heading);
  const std::pair<const char*, peers::Peer> methods[] = {{"Xu et al. 2012, clustered", xu},
                                                         {"Zheng et al. 2014", peers::match_zheng_2014},
                                                         {"Kim et al. 2013", peers::match_kim_2013},
                                                         {"the paper's method", ours_by(paper_options(), all_pairs)},
                                                         {"the same without outliers", ours_by(paper_options())},
                                                         {"default", ours_by(default_options())}};
  for (const auto& [name, method] : methods) {
    const Run of_set = run(dataset, method);
    std::vector<std::string> cells{name};
    for (const auto& [category, mean] : of_set.evaluation.categories)
      cells.push_back(text(mean.coarse_precision.mean, 2));
    const Estimate& precision = of_set.evaluation.mean.coarse_precision;
    cells.push_back(text(precision.mean));
    cells.push_back(text(precision.low, 2) + "–" + text(precision.high, 2));
    cells.push_back(text(coarse_recall(dataset, of_set)));
    write_row(cells);
  }
}

inline void table3(const Dataset& dataset)
{
  const peers::Peer paper = ours(paper_options());
  compare(dataset, {{"Xu et al. 2012", peers::pairwise(peers::match_xu_2012)},
                    {"the paper's method, no symmetry", without_symmetry(paper)},
                    {"the paper's method", paper},
                    {"default, no symmetry", without_symmetry(ours(default_options()))},
                    {"default", ours(default_options())}});
}

inline void compare_peers(const Dataset& dataset)
{
  std::vector<std::pair<std::string, peers::Peer>> methods{{"default", ours(default_options())},
                                                           {"the paper's method (beam)", ours(paper_options())},
                                                           {"least energy (exact)", ours(exact_options())}};
  for (const peers::Named_peer& peer : peers::all_peers())
    methods.emplace_back(peer.name, peer.match);
  compare(dataset, methods);
  std::cout << "\nSimplified:\n";
  for (const peers::Named_peer& peer : peers::all_peers())
    if (peer.simplified != "-") std::cout << "- " << peer.name << ": " << peer.simplified << '\n';
}

/// The share of right pairs for each tenth of confidence, and the expected calibration error.
inline void reliability(const Dataset& dataset, const Options& options)
{
  constexpr int bins = 10;
  std::vector<double> confidence(bins, 0), right(bins, 0), count(bins, 0);
  double error = 0, total = 0;
  for (const Category& category : dataset)
    for (const auto& [s, t] : category.pairs) {
      const Correspondence c = find_correspondence(category.graphs[s], category.graphs[t]);
      const Ground_truth truth = ground_truth(category.labels[s], category.labels[t]);
      for (const Part_correspondence& pair : c.pairs) {
        const int bin = std::min(int(pair.confidence * bins), bins - 1);
        const std::pair<std::size_t, std::size_t> parts(pair.source, pair.target);
        confidence[std::size_t(bin)] += pair.confidence;
        right[std::size_t(bin)] += std::binary_search(truth.pairs.begin(), truth.pairs.end(), parts);
        ++count[std::size_t(bin)];
        ++total;
      }
    }
  write_heading({"confidence", "pairs", "right"});
  Chart chart;
  chart.x_title = "confidence of pairs, mean of a tenth";
  chart.y_title = "share of them that is right";
  chart.lines = {{"measured", "#0a62c4", {}, false}, {"as stated", "#c43b0a", {{0, 0}, {1, 1}}, true}};
  for (std::size_t b = 0; b < bins; ++b) {
    if (count[b] == 0) continue;
    const Eigen::Vector2d point(confidence[b] / count[b], right[b] / count[b]);
    error += count[b] / total * std::abs(point.x() - point.y());
    write_row({text(point.x(), 2), std::to_string(int(count[b])), text(point.y(), 2)});
    chart.lines[0].points.push_back(point);
  }
  std::cout << "\nExpected calibration error: " << text(error) << '\n';
  std::ofstream out = picture(options, "reliability.svg");
  chart.write(out);
}

} // namespace CGAL::Shape_correspondence::experiments

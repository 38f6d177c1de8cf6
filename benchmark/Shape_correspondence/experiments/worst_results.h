// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// The results of least F1.
#ifndef CGAL_SHAPE_CORRESPONDENCE_EXPERIMENTS_WORST_RESULTS_H
#define CGAL_SHAPE_CORRESPONDENCE_EXPERIMENTS_WORST_RESULTS_H

#include "gallery.h"

namespace CGAL {
namespace Shape_correspondence {
namespace experiments {

inline std::string named_pairs(const Part_pairs& pairs, const Category& category, std::size_t s, std::size_t t)
{
  std::string result;
  for (const auto& [i, j] : pairs) {
    const auto name = [&](std::size_t shape, std::size_t part) {
      const Part_label& label = category.labels[shape][part];
      return structure(category.graphs[shape]).parts[part].name + " (" +
             (label.fine.empty() ? label.coarse : label.fine) + ")";
    };
    result += (result.empty() ? "" : ", ") + name(s, i) + " – " + name(t, j);
  }
  return result.empty() ? "none" : result;
}

inline Part_pairs difference(const Part_pairs& a, const Part_pairs& b)
{
  Part_pairs result;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
  return result;
}

/// Pages of the results of least F1, and an index of them with what is wrong and what is missed.
inline void worst(const Dataset& dataset, const Options& options)
{
  struct Result
  {
    const Category* category;
    peers::Shape_pair pair;
    Correspondence correspondence;
    Correspondence_score score;
  };
  constexpr std::size_t shown = 20;
  std::vector<Result> results;
  for (const Category& category : dataset)
    for (const auto& pair : category.pairs) {
      Correspondence c = find_correspondence(category.graphs[pair[0]], category.graphs[pair[1]]);
      const Ground_truth truth = ground_truth(category.labels[pair[0]], category.labels[pair[1]]);
      const Correspondence_score scored = evaluate_correspondence(part_pairs(c.pairs), truth);
      results.push_back({&category, pair, std::move(c), scored});
    }
  std::stable_sort(results.begin(), results.end(),
                   [](const Result& a, const Result& b) { return a.score.f1() < b.score.f1(); });
  results.resize(std::min(results.size(), shown));
  Picture_pages pages(options, "worst", "Worst results");
  write_heading({"category", "source", "target", "P", "R", "F1"});
  for (const auto& [category, pair, correspondence, scored] : results) {
    const auto [s, t] = pair;
    write_row({category->name, category->shapes[s], category->shapes[t], text(scored.precision(), 2),
               text(scored.recall(), 2), text(scored.f1(), 2)});
    const Ground_truth truth = ground_truth(category->labels[s], category->labels[t]);
    const Part_pairs pairs = part_pairs(correspondence.pairs);
    pages.add(category->name + ": " + pair_name(*category, pair) + ", F1 " + text(scored.f1(), 2), *category, pair,
              correspondence,
              "<p>Wrong: " + named_pairs(difference(pairs, truth.pairs), *category, s, t) +
                  "</p><p>Missed: " + named_pairs(difference(truth.pairs, pairs), *category, s, t) + "</p>");
  }
}

} // namespace experiments
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_EXPERIMENTS_WORST_RESULTS_H

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

// Compares the methods of part abstraction: deviations from the curves and sheets that the generator states, and F1
// of matching.
#pragma once

#include "../abstraction_error.h"
#include "methods.h"

namespace CGAL::Shape_correspondence::experiments {

/// Comparison of the abstractions of parts with the curves and sheets that the generator states.
struct Abstraction_scores
{
  std::size_t stated = 0, kinds_right = 0, parts = 0, fallbacks = 0;
  std::vector<double> curve_deviations, sheet_deviations; ///< from those of the generator, over the part's diagonal
  std::vector<double> residuals;                          ///< RMS distances of fitted points, without copies of parts
  double seconds = 0;                                     ///< processor time, summed over all shapes
};

inline void compare_with_stated(const Segmented_shape& model, const Structural_graph& graph, const std::string& folder,
                                Abstraction_scores& scores)
{
  const std::map<std::string, Part_abstraction> stated = benchmark::stated_abstractions(folder);
  for (std::size_t i = 0; i < model.parts().size(); ++i) {
    const Part_abstraction& part = structure(graph).parts[i];
    ++scores.parts;
    scores.fallbacks += part.report.is_fallback();
    if (part.report.copy_of.empty()) scores.residuals.push_back(part.report.residual);
    const auto found = stated.find(part.name);
    if (found == stated.end()) continue;
    ++scores.stated;
    scores.kinds_right += benchmark::same_kind(part, found->second);
    std::vector<double>& deviations = found->second.is_sheet() ? scores.sheet_deviations : scores.curve_deviations;
    for (double deviation : benchmark::deviations(part, found->second))
      deviations.push_back(deviation / benchmark::diagonal(model.parts()[i].mesh.points));
  }
}

/// Replaces the graphs of all shapes by new ones, made without the cache so that the time can be measured.
inline Abstraction_scores abstract_all(const Structure_options& options, Dataset& dataset)
{
  Abstraction_scores scores;
  for (Category& category : dataset)
    for (std::size_t k = 0; k < category.shapes.size(); ++k) {
      const Segmented_shape model = IO::read_segmented_shape(category.folders[k], Point::UnitY());
      const std::clock_t begin = std::clock();
      category.graphs[k] = build_structural_graph(model, options);
      scores.seconds += double(std::clock() - begin) / CLOCKS_PER_SEC;
      compare_with_stated(model, category.graphs[k], fs::path(category.folders[k]).parent_path().string(), scores);
    }
  return scores;
}

inline void compare_abstractions(Dataset dataset)
{
  using benchmark::quantile;
  struct Way
  {
    const char* name;
    decltype(Abstraction_options::abstractor) abstractor;
    bool has_closest_points = false; // whether contact points are the closest points
  };
  const Way ways[] = {
      {"flow, contacts at closest points: `paper_structure_options()`", Mean_curvature_abstraction(), true},
      {"flow: `Mean_curvature_abstraction`", Mean_curvature_abstraction()},
      {"fitted: `Fitted_abstraction`, the default", Fitted_abstraction()},
      {"fitted, contacts at closest points", Fitted_abstraction(), true},
      {"boxes: `Bounding_box_abstraction`", Bounding_box_abstraction()}};
  std::size_t shapes = 0;
  for (const Category& category : dataset)
    shapes += category.shapes.size();
  write_heading({"abstraction", "kinds as stated", "curves off by, median", "95 %", "sheets off by, median", "95 %",
                 "residual, median", "95 %", "boxes stand in", "F1 paper", "F1 default", "CPU s / shape"});
  for (const Way& way : ways) {
    Structure_options options;
    options.abstraction.abstractor = way.abstractor;
    options.contacts.closest_points = way.has_closest_points;
    const Abstraction_scores s = abstract_all(options, dataset);
    std::vector<std::string> cells{
        way.name, s.stated == 0 ? "-" : std::to_string(s.kinds_right) + " of " + std::to_string(s.stated)};
    for (const std::vector<double>* deviations : {&s.curve_deviations, &s.sheet_deviations})
      for (double fraction : {0.5, 0.95})
        cells.push_back(deviations->empty() ? "-" : text(quantile(*deviations, fraction), 4));
    for (double fraction : {0.5, 0.95})
      cells.push_back(text(quantile(s.residuals, fraction), 4));
    cells.push_back(std::to_string(s.fallbacks) + " of " + std::to_string(s.parts));
    for (const Search_options& search : {paper_options(), default_options()})
      cells.push_back(text(run(dataset, ours(search)).evaluation.mean.f1.mean));
    cells.push_back(text(s.seconds / double(shapes), 2));
    write_row(cells);
  }
}

} // namespace CGAL::Shape_correspondence::experiments

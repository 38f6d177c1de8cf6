// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Weights and bounds of the default method, fitted to labelled shapes and judged on categories that were left out.
#ifndef CGAL_SHAPE_CORRESPONDENCE_EXPERIMENTS_FIT_H
#define CGAL_SHAPE_CORRESPONDENCE_EXPERIMENTS_FIT_H

#include "methods.h"
#include "options.h"

#include <deque>
#include <map>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {
namespace experiments {

struct Fitted_constant
{
  const char* name;
  double& (*value)(Part_matching_options&);
};

/// The constants that are fitted. That of chains is as good as infinite.
inline const std::vector<Fitted_constant>& fitted_constants()
{
  static const std::vector<Fitted_constant> constants{
      {"overlap", [](Part_matching_options& o) -> double& { return o.weights.overlap; }},
      {"extent", [](Part_matching_options& o) -> double& { return o.weights.extent; }},
      {"ground", [](Part_matching_options& o) -> double& { return o.weights.ground; }},
      {"side", [](Part_matching_options& o) -> double& { return o.weights.side; }},
      {"front", [](Part_matching_options& o) -> double& { return o.weights.front; }},
      {"orientation", [](Part_matching_options& o) -> double& { return o.weights.orientation; }},
      {"chamfer", [](Part_matching_options& o) -> double& { return o.weights.chamfer; }},
      {"contacts", [](Part_matching_options& o) -> double& { return o.weights.contacts; }},
      {"excess", [](Part_matching_options& o) -> double& { return o.excess; }},
      {"confident_excess", [](Part_matching_options& o) -> double& { return o.confident_excess; }},
      {"shared_counterpart", [](Part_matching_options& o) -> double& { return o.shared_counterpart; }}};
  return constants;
}

using F1_by_category = std::map<std::string, double>;

/// F1 of the default method without roles, by its options; what was asked for before is kept.
class Fit_objective
{
public:
  explicit Fit_objective(const std::vector<Dataset>& datasets) : datasets_(datasets)
  {
    for (const Dataset& dataset : datasets)
      for (const Category& category : dataset) {
        shapes_.emplace_back();
        for (const Structural_graph& graph : category.graphs)
          shapes_.back().emplace_back(graph);
      }
  }

  const F1_by_category& operator()(Part_matching_options options)
  {
    std::vector<double> key;
    for (const Fitted_constant& constant : fitted_constants())
      key.push_back(constant.value(options));
    const auto [found, is_new] = known_.try_emplace(key);
    if (is_new) found->second = measured(options);
    return found->second;
  }

  /// The mean of the categories but one. \param left_out empty: of all
  double mean(const Part_matching_options& options, const std::string& left_out)
  {
    double sum = 0, count = 0;
    for (const auto& [category, f1] : (*this)(options))
      if (category != left_out) sum += f1, count += 1;
    return sum / count;
  }

private:
  F1_by_category measured(const Part_matching_options& options) const
  {
    Search_options search;
    search.parts = options;
    std::map<std::string, std::pair<double, int>> sums;
    std::size_t c = 0;
    for (const Dataset& dataset : datasets_)
      for (const Category& category : dataset) {
        for (const auto& [s, t] : category.pairs) {
          const Correspondence found = Correspondence_finder(shapes_[c][s], search)(shapes_[c][t]);
          sums[category.name].first +=
              evaluate_correspondence(part_pairs(found.pairs), ground_truth(category.labels[s], category.labels[t]))
                  .f1();
          ++sums[category.name].second;
        }
        ++c;
      }
    F1_by_category result;
    for (const auto& [name, sum] : sums)
      result[name] = sum.first / sum.second;
    return result;
  }

  const std::vector<Dataset>& datasets_;
  std::deque<std::vector<Prepared_shape>> shapes_; // by category of the data sets in a row
  std::map<std::vector<double>, F1_by_category> known_;
};

/// Coordinate descent by factors from the defaults: a constant is changed where the mean F1 of the categories but one
/// gains more than chance gives away.
inline Part_matching_options fitted(Fit_objective& f1, const std::string& left_out)
{
  constexpr double least_gain = 0.001;
  constexpr int sweeps = 2;
  Part_matching_options best;
  for (int sweep = 0; sweep < sweeps; ++sweep)
    for (const Fitted_constant& constant : fitted_constants()) {
      Part_matching_options tried[] = {best, best};
      constant.value(tried[0]) *= 1.5;
      constant.value(tried[1]) /= 1.5;
      for (const Part_matching_options& options : tried)
        if (f1.mean(options, left_out) > f1.mean(best, left_out) + least_gain) best = options;
    }
  return best;
}

/// `fit DATA [FURTHER_DATA...]`
inline void fit(const Dataset& dataset, const Options& options)
{
  std::vector<Dataset> datasets{dataset};
  for (std::size_t i = 1; i < options.data.size(); ++i)
    datasets.push_back(load(options.data[i], options));
  Fit_objective f1(datasets);
  std::vector<std::string> heading{"left out of the fit", "its F1 by the defaults", "fitted to the others"};
  for (const Fitted_constant& constant : fitted_constants())
    heading.push_back(constant.name);
  write_heading(heading);
  const auto write = [&](const std::string& name, double before, double after, Part_matching_options values) {
    std::vector<std::string> cells{name, text(before), text(after)};
    for (const Fitted_constant& constant : fitted_constants())
      cells.push_back(text(constant.value(values), 2));
    write_row(cells);
  };
  const F1_by_category before = f1({});
  double mean_before = 0, mean_after = 0;
  for (const auto& [category, value] : before) {
    const Part_matching_options values = fitted(f1, category);
    const double after = f1(values).at(category);
    write(category, value, after, values);
    mean_before += value / double(before.size());
    mean_after += after / double(before.size());
  }
  write("mean of these", mean_before, mean_after, {});
  const Part_matching_options values = fitted(f1, "");
  write("none: in sample", f1.mean({}, ""), f1.mean(values, ""), values);

  std::cout << "\nWithout a constant, defaults otherwise:\n\n";
  std::vector<std::string> without_heading{"without", "mean F1"};
  for (const auto& [category, value] : before)
    without_heading.push_back(category);
  write_heading(without_heading);
  const auto write_without = [&](const char* name, const F1_by_category& found) {
    std::vector<std::string> cells{name, ""};
    double sum = 0;
    for (const auto& [category, value] : found) {
      cells.push_back(text(value));
      sum += value;
    }
    cells[1] = text(sum / double(found.size()));
    write_row(cells);
  };
  write_without("nothing", before);
  for (const Fitted_constant& constant : fitted_constants()) {
    Part_matching_options none;
    constant.value(none) = 0;
    write_without(constant.name, f1(none));
  }
}

} // namespace experiments
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_EXPERIMENTS_FIT_H

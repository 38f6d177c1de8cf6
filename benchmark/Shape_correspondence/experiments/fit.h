// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// The constants of the match by parts: fitted to labelled shapes and judged on categories that were left out, and what
// each of them and each rule is worth.
#ifndef CGAL_SHAPE_CORRESPONDENCE_EXPERIMENTS_FIT_H
#define CGAL_SHAPE_CORRESPONDENCE_EXPERIMENTS_FIT_H

#include "matching/Shape_features.h"
#include "matching/match_parts.h"
#include "matching_constants.h"
#include "methods.h"
#include "options.h"
#include "role_validation.h"

#include <deque>
#include <map>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {
namespace experiments {

inline std::vector<Dataset> all_datasets(const Dataset& first, const Options& options)
{
  std::vector<Dataset> result{first};
  for (std::size_t i = 1; i < options.data.size(); ++i)
    result.push_back(load(options.data[i], options));
  return result;
}

using F1_by_category = std::map<std::string, double>;

/// F1 of the match by geometry, by its options; what was asked for before is kept.
class Fit_objective
{
public:
  explicit Fit_objective(const std::vector<Dataset>& datasets) : datasets_(datasets)
  {
    for (const Dataset& dataset : datasets)
      for (const Category& category : dataset) {
        shapes_.emplace_back();
        for (const Structural_graph& graph : category.graphs)
          shapes_.back().push_back(align_shape(graph, given_quarter_turns(structure(graph).frame)));
      }
  }

  const F1_by_category& operator()(const Part_matching_options& options)
  {
    std::vector<double> key;
    for (const Matching_constant& constant : matching_constants())
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
    std::map<std::string, std::pair<double, int>> sums;
    std::size_t c = 0;
    for (const Dataset& dataset : datasets_)
      for (const Category& category : dataset) {
        std::deque<internal::Shape_features> features;
        for (const Aligned_shape& shape : shapes_[c])
          features.emplace_back(shape, options);
        for (const auto& [s, t] : category.pairs) {
          const Part_matching found = match_parts(features[s], features[t], options, {});
          Part_pairs pairs;
          for (const Part_correspondence& pair : found.pairs)
            pairs.emplace_back(shapes_[c][s].original[pair.source], shapes_[c][t].original[pair.target]);
          std::sort(pairs.begin(), pairs.end());
          sums[category.name].first +=
              evaluate_correspondence(pairs, ground_truth(category.labels[s], category.labels[t])).f1();
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
  std::vector<std::vector<Aligned_shape>> shapes_; // by category of the data sets in a row
  std::map<std::vector<double>, F1_by_category> known_;
};

/// Coordinate descent by factors from the present values: a constant is changed where the mean F1 of the categories but
/// one gains more than chance gives away.
inline Part_matching_options fitted(Fit_objective& f1, const std::string& left_out)
{
  constexpr double least_gain = 0.002, factor = 1.25;
  constexpr int sweeps = 2;
  Part_matching_options best;
  for (int sweep = 0; sweep < sweeps; ++sweep)
    for (const Matching_constant& constant : matching_constants()) {
      if (!constant.is_fitted) continue;
      const double value = constant.value(best);
      for (double tried : {value * factor, value / factor}) {
        Part_matching_options options = best;
        constant.set(std::stod(short_number(tried)), options);
        if (f1.mean(options, left_out) > f1.mean(best, left_out) + least_gain) best = options;
      }
    }
  return best;
}

/// `fit DATA [FURTHER_DATA...]`. The header gets the values that were fitted to all categories, unless fits score less
/// than the present values on categories that they did not see.
inline void fit(const Dataset& dataset, const Options& options)
{
  const std::vector<Dataset> datasets = all_datasets(dataset, options);
  Fit_objective f1(datasets);
  std::vector<std::string> heading{"left out of the fit", "its F1 by the present values", "fitted to the others"};
  for (const Matching_constant& constant : matching_constants())
    if (constant.is_fitted) heading.push_back(constant.name);
  write_heading(heading);
  const auto write = [&](const std::string& name, double before, double after, const Part_matching_options& values) {
    std::vector<std::string> cells{name, text(before), text(after)};
    for (const Matching_constant& constant : matching_constants())
      if (constant.is_fitted) cells.push_back(short_number(constant.value(values)));
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
  const bool travels = mean_after > mean_before;
  std::ofstream(fs::path(options.out) / "Part_matching_options.h")
      << matching_header(travels ? values : Part_matching_options());
}

/// A change of the options.
struct Variant
{
  std::string name;
  Part_matching_options options;
};

/// Every constant less, more and, where that switches a term or rule off, without; every rule switched off.
inline std::vector<Variant> variants_of_constants()
{
  std::vector<Variant> result{{"as they are", {}}};
  const auto add = [&](const std::string& name, const Matching_constant& constant, double value) {
    result.push_back({name, {}});
    constant.set(value, result.back().options);
  };
  for (const Matching_constant& constant : matching_constants()) {
    const std::string name = constant.name;
    const double value = constant.value({});
    if (constant.is_weight() || name == "excess" || name == "confident_excess") add("no " + name, constant, 0);
    if (name == "whole") add("no wholes", constant, 1e3);
    if (name == "anchor") add("no warp", constant, 1e3);
    add(name + " × 0.7", constant, name == "repetition" ? value - 1 : 0.7 * value);
    add(name + " × 1.4", constant, name == "repetition" ? value + 1 : 1.4 * value);
  }
  for (const auto& [name, rule] : {std::pair("no panels", &Part_matching_options::panels),
                                   std::pair("no support", &Part_matching_options::support)}) {
    result.push_back({name, {}});
    result.back().options.*rule = false;
  }
  return result;
}

/// P, R and F1: means of pairs by category, then of categories.
inline std::array<double, 3> mean_scores_of(const std::vector<Validated_pair>& pairs,
                                            const std::vector<std::string>& categories,
                                            Correspondence_score Validated_pair::*score)
{
  std::vector<Scored_correspondence> scores;
  for (const Validated_pair& pair : pairs)
    scores.push_back({categories[pair.shapes[0]], "", "", pair.*score});
  Evaluation_options no_intervals;
  no_intervals.resamples = 1;
  const Mean_score mean = mean_scores(scores, no_intervals).mean;
  return {mean.precision.mean, mean.recall.mean, mean.f1.mean};
}

/// `constants DATA [FURTHER_DATA...] [--generated FOLDER]`
inline void constants(const Dataset& dataset, const Options& options)
{
  std::vector<Dataset> datasets = all_datasets(dataset, options);
  const std::size_t labelled = datasets.size();
  if (!options.generated.empty()) datasets.push_back(load(options.generated, options));
  std::vector<Validation_shape> shapes;
  std::vector<Shape_pair> pairs;
  std::vector<std::string> categories;
  for (std::size_t d = 0; d < datasets.size(); ++d)
    for (const Category& category : datasets[d]) {
      const std::size_t first = shapes.size();
      for (std::size_t i = 0; i < category.graphs.size(); ++i) {
        const double weight = d < labelled ? weight_of_real_shapes : 1;
        shapes.push_back(
            {{&category.graphs[i], category.name, category.labels[i], weight}, category.families[i], d >= labelled});
        categories.push_back(category.name);
      }
      for (const auto& [s, t] : category.pairs)
        if (d < labelled) pairs.push_back({first + s, first + t});
    }
  Role_validation validation(shapes, pairs, {}, {});
  write_heading({"constants and rules", "geometry P", "R", "F1", "change", "with roles P", "R", "F1", "change"});
  std::array<double, 2> usual{};
  for (const Variant& variant : variants_of_constants()) {
    validation.match(variant.options);
    std::vector<std::string> cells{variant.name};
    for (std::size_t with : {0u, 1u}) {
      const std::array<double, 3> scores =
          mean_scores_of(validation.pairs(), categories, with ? &Validated_pair::joined : &Validated_pair::geometric);
      if (cells[0] == "as they are") usual[with] = scores[2];
      for (double score : scores)
        cells.push_back(text(score));
      cells.push_back(text(scores[2] - usual[with]));
    }
    write_row(cells);
  }
}

} // namespace experiments
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_EXPERIMENTS_FIT_H

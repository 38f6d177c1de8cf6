// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/role_reports.h"
#include "cli/text.h"
#include "matching/mean_differences.h"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <map>
#include <utility>

namespace CGAL::Shape_correspondence::cli {
using namespace internal;

namespace {

std::string decimals(double number)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.3f", number);
  return text;
}

using Score_of = std::function<const Correspondence_score&(const Validated_pair&)>;

std::vector<Scored_correspondence> scores_of(const Role_training_set& set, const Role_validation& validation,
                                             const Score_of& score)
{
  std::vector<Scored_correspondence> result;
  for (const Validated_pair& pair : validation.pairs()) {
    const Labelled_model &a = set.models[pair.shapes[0]], &b = set.models[pair.shapes[1]];
    result.push_back({a.labels.category, a.folder + '/' + a.labels.name, b.folder + '/' + b.labels.name, score(pair)});
  }
  return result;
}

const Correspondence_score& geometric_score(const Validated_pair& pair) { return pair.geometric; }
const Correspondence_score& joined_score(const Validated_pair& pair) { return pair.joined; }

/// By geometry alone, with roles, and the paired difference.
struct Evaluations
{
  Evaluation geometric, joined, gain;

  Evaluations(const Role_training_set& set, const Role_validation& validation, std::uint64_t seed)
  {
    const std::vector<Scored_correspondence> without = scores_of(set, validation, geometric_score),
                                             with = scores_of(set, validation, joined_score);
    Evaluation_options options;
    options.seed = seed;
    geometric = mean_scores(without, options);
    joined = mean_scores(with, options);
    gain = mean_differences(with, without, options);
  }
};

std::string interval_text(const Estimate& estimate) { return decimals(estimate.low) + ".." + decimals(estimate.high); }

/// How well confidences tell right from wrong. Every pair of shapes of a category weighs the same.
struct Calibration
{
  bool has_confidences = false;
  double stated = 0, right = 0; // mean confidence of the pairs of parts, and share of those that are right
  double auc = 0;               // how often a pair that is right has more confidence than one that is wrong
  double sure_precision = 0;    // share that is right of those of a confidence of `sure` or more
  double sure_share = 0;        // and how many of all they are
};
constexpr double sure = 0.7;

/// \param category empty: all, of which each weighs the same
Calibration calibration_of(const Role_training_set& set, const Role_validation& validation, const std::string& category)
{
  struct Weighted_pair
  {
    double confidence, weight;
    bool is_right;
  };
  std::map<std::string, double> pairs_of;
  const auto category_of = [&](const Validated_pair& pair) { return set.models[pair.shapes[0]].labels.category; };
  for (const Validated_pair& pair : validation.pairs())
    if (!pair.judged.empty() && (category.empty() || category == category_of(pair))) ++pairs_of[category_of(pair)];
  std::vector<Weighted_pair> all;
  for (const Validated_pair& pair : validation.pairs())
    for (const Judged_pair& judged : pair.judged)
      if (pairs_of.count(category_of(pair)) > 0)
        all.push_back({judged.confidence,
                       1 / (double(pairs_of.size()) * pairs_of[category_of(pair)] * double(pair.judged.size())),
                       judged.is_right});
  std::sort(all.begin(), all.end(),
            [](const Weighted_pair& a, const Weighted_pair& b) { return a.confidence < b.confidence; });
  Calibration result;
  result.has_confidences = !all.empty();
  double wrong = 0, ordered = 0, sure_right = 0;
  for (const Weighted_pair& pair : all) {
    result.stated += pair.weight * pair.confidence;
    (pair.is_right ? result.right : wrong) += pair.weight;
    if (pair.is_right) ordered += pair.weight * wrong;
    if (pair.confidence < sure) continue;
    result.sure_share += pair.weight;
    if (pair.is_right) sure_right += pair.weight;
  }
  if (result.right * wrong > 0) result.auc = ordered / (result.right * wrong);
  if (result.sure_share > 0) result.sure_precision = sure_right / result.sure_share;
  return result;
}

/// How often the front of a shape is among those that are thought possible, or the only one; - where no category was
/// told.
/// \param category empty: the mean of all
std::string share_of_fronts(const Role_training_set& set, const Role_validation& validation,
                            const std::string& category, int Front_count::*fronts)
{
  std::map<std::string, Front_count> counts;
  for (const Validated_pair& pair : validation.pairs()) {
    const std::string& name = set.models[pair.shapes[0]].labels.category;
    if (pair.fronts.shapes == 0 || (!category.empty() && name != category)) continue;
    counts[name].shapes += pair.fronts.shapes;
    counts[name].*fronts += pair.fronts.*fronts;
  }
  double sum = 0;
  for (const auto& [name, count] : counts)
    sum += double(count.*fronts) / count.shapes;
  return counts.empty() ? "-" : decimals(sum / double(counts.size()));
}

/// The mean of the pairs, every category with the same weight.
/// \param category empty: all
double mean_share(const Role_training_set& set, const Role_validation& validation, const std::string& category,
                  double Validated_pair::*share)
{
  std::map<std::string, std::pair<double, int>> sums;
  for (const Validated_pair& pair : validation.pairs()) {
    const std::string& name = set.models[pair.shapes[0]].labels.category;
    if (!category.empty() && name != category) continue;
    sums[name].first += pair.*share;
    ++sums[name].second;
  }
  double result = 0;
  for (const auto& [name, sum] : sums)
    result += sum.first / sum.second / double(sums.size());
  return result;
}

/// Of the terms of a pair, see `Pair_term`.
IO::Json json_of(const Pair_weights& weights)
{
  IO::Json result;
  result["same_label"] = weights[SAME_LABEL];
  result["same_role"] = weights[SAME_ROLE];
  result["votes_agree"] = weights[VOTES_AGREE];
  result["geometric_pair"] = weights[GEOMETRIC_PAIR];
  result["excess"] = weights[EXCESS];
  result["constant"] = weights[CONSTANT];
  return result;
}

/// Of the confidence of a pair, see `Confidence_term`.
IO::Json json_of(const Confidence_weights& weights)
{
  IO::Json result;
  result["slope"] = weights[SLOPE];
  result["offset"] = weights[OFFSET];
  return result;
}

IO::Json json_of(const Mean_score& score)
{
  IO::Json result;
  for (const auto& [name, estimate] :
       {std::pair("precision", score.precision), std::pair("recall", score.recall), std::pair("f1", score.f1)}) {
    result[name]["mean"] = estimate.mean;
    result[name]["low"] = estimate.low;
    result[name]["high"] = estimate.high;
  }
  return result;
}

IO::Json json_of(const Role_training_set& set, const Role_validation& validation, std::uint64_t seed)
{
  const Evaluations found(set, validation, seed);
  IO::Json result = IO::Json::array();
  const auto add = [&](const std::string& category, const Mean_score& without, const Mean_score& with,
                       const Mean_score& gain) {
    IO::Json entry;
    entry["category"] = category;
    entry["pairs"] = without.correspondences;
    entry["geometry"] = json_of(without);
    entry["with_roles"] = json_of(with);
    entry["gain"] = json_of(gain);
    entry["labels"] =
        mean_share(set, validation, category == "mean" ? "" : category, &Validated_pair::labels_by_geometry);
    entry["labels_with_roles"] =
        mean_share(set, validation, category == "mean" ? "" : category, &Validated_pair::labels_joined);
    result.push_back(std::move(entry));
  };
  for (std::size_t c = 0; c < found.gain.categories.size(); ++c)
    add(found.gain.categories[c].first, found.geometric.categories[c].second, found.joined.categories[c].second,
        found.gain.categories[c].second);
  add("mean", found.geometric.mean, found.joined.mean, found.gain.mean);
  return result;
}

IO::Json pairs_json(const Role_training_set& set, const Role_validation& validation)
{
  IO::Json result = IO::Json::array();
  for (const Validated_pair& pair : validation.pairs()) {
    IO::Json entry;
    entry["category"] = set.models[pair.shapes[0]].labels.category;
    entry["source"] = set.models[pair.shapes[0]].labels.file;
    entry["target"] = set.models[pair.shapes[1]].labels.file;
    entry["category_found"] = pair.category;
    entry["geometry"] = pair.geometric.f1();
    entry["with_roles"] = pair.joined.f1();
    entry["confidences"] = IO::Json::array();
    for (const Judged_pair& judged : pair.judged)
      entry["confidences"].push_back({judged.confidence, judged.is_right, judged.has_one_role});
    result.push_back(std::move(entry));
  }
  return result;
}

} // namespace

void write_role_table(std::ostream& out, const Role_training_set& set, const Role_validation& validation,
                      std::uint64_t seed)
{
  const Evaluations found(set, validation, seed);
  std::vector<std::vector<std::string>> rows{{"category",     "pairs",  "geometry P", "R",      "F1",
                                              "with roles P", "R",      "F1",         "95 %",   "gain",
                                              "95 %",         "stated", "right",      "AUC",    "P sure",
                                              "share",        "front",  "sure front", "labels", "with roles"}};
  const auto add_row = [&](const std::string& name, const Mean_score& without, const Mean_score& with,
                           const Mean_score& gain) {
    rows.push_back({name, std::to_string(without.correspondences)});
    for (const Mean_score* score : {&without, &with})
      for (const Estimate* estimate : {&score->precision, &score->recall, &score->f1})
        rows.back().push_back(decimals(estimate->mean));
    const Calibration confidences = calibration_of(set, validation, name == "mean" ? "" : name);
    for (const std::string& text : {interval_text(with.f1), decimals(gain.f1.mean), interval_text(gain.f1)})
      rows.back().push_back(text);
    for (double value :
         {confidences.stated, confidences.right, confidences.auc, confidences.sure_precision, confidences.sure_share})
      rows.back().push_back(confidences.has_confidences ? decimals(value) : "-");
    for (const auto fronts : {&Front_count::possible, &Front_count::sure})
      rows.back().push_back(share_of_fronts(set, validation, name == "mean" ? "" : name, fronts));
    for (const auto labels : {&Validated_pair::labels_by_geometry, &Validated_pair::labels_joined})
      rows.back().push_back(decimals(mean_share(set, validation, name == "mean" ? "" : name, labels)));
  };
  for (std::size_t c = 0; c < found.gain.categories.size(); ++c)
    add_row(found.gain.categories[c].first, found.geometric.categories[c].second, found.joined.categories[c].second,
            found.gain.categories[c].second);
  add_row("mean", found.geometric.mean, found.joined.mean, found.gain.mean);
  write_table(out, rows);
}

IO::Json role_evaluation_json(const Role_training_set& set, const Role_validation& validation,
                              const std::string& left_out, std::uint64_t seed)
{
  IO::Json result;
  result["format"] = "shape_correspondence/role_evaluation";
  result["version"] = 1;
  result["left_out"] = left_out;
  result["categories"] = json_of(set, validation, seed);
  result["weights"] = json_of(validation.weights());
  result["pairs"] = pairs_json(set, validation);
  return result;
}

IO::Json role_manifest_json(const Role_training_set& set, const Role_validation& validation, const Role_model& model,
                            const std::string& date, const Role_training_options& training)
{
  IO::Json result;
  result["format"] = "shape_correspondence/role_manifest";
  result["version"] = 1;
  if (!date.empty()) result["date"] = date;
  result["seed"] = training.seed;
  result["trees"] = training.trees;
  result["categories"] = IO::Json::array();
  for (const std::string& category : model.categories()) {
    IO::Json entry;
    entry["category"] = category;
    entry["roles"] = IO::Json(model.roles(category));
    const Category_roles& learned = model.data().categories[model.data().index(category)];
    entry["weights"] = json_of(learned.weights);
    entry["confidence"] = json_of(learned.confidence);
    entry["geometric_confidence"] = json_of(learned.geometric_confidence);
    result["categories"].push_back(std::move(entry));
  }
  result["weights"] = json_of(validation.weights());
  // Of shapes of either kind that the training did not see
  if (!set.pairs.empty()) result["left_out_shapes"] = json_of(set, validation, training.seed);
  result["generated_shapes"] = set.models.size() - set.number_of_real;
  result["shapes"] = IO::Json::array();
  for (std::size_t i = 0; i < set.number_of_real; ++i) {
    const IO::Labelled_shape& shape = set.models[i].labels;
    IO::Json entry;
    entry["category"] = shape.category;
    entry["name"] = shape.name;
    entry["source"] = shape.source;
    entry["license"] = shape.license;
    result["shapes"].push_back(std::move(entry));
  }
  return result;
}

} // namespace CGAL::Shape_correspondence::cli

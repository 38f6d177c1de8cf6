// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

// Measures by how much roles improve the matching of shapes that were left out of the training.

#include "cli/jobs.h"
#include "cli/run.h"
#include "command_line.h"
#include "experiments/intervals.h"
#include "experiments/role_validation.h"

#include <CGAL/Shape_correspondence/IO/role_model.h>

#include <nlohmann/json.hpp>

#include <cstdio>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <set>

using namespace CGAL::Shape_correspondence;
using namespace CGAL::Shape_correspondence::experiments;

namespace {

using Json = nlohmann::ordered_json;

constexpr int bad_input = 1, bad_usage = 2;

const char* const help_text =
    R"(Usage: validate_roles FOLDER... [--json FILE] [options]

Learns roles from labelled shapes, as `shape_correspondence roles train` does, and matches pairs of shapes that were left out
of the training.

  --generated FOLDER       further labelled shapes that are generated; they have a third of the weight of real ones and are
                           never left out. Can be repeated
  --generated-shapes N     use N of the generated shapes, of every category alike. Default: all
  --generated-per-tree N   a tree sees at most N generated shapes of its category (40)
  --leave-out WHAT         what is left out of the training for a pair of shapes: shapes (the two; the default), sources (all
                           shapes with their `source` in labels.json) or category (all shapes of their category)
  --number-of-examples N   the training sees at most N shapes of the pair's category that are not generated, drawn for every
                           pair; with --leave-out category, no others of the category. Default: all that are not left out
  --told                   give the category to the matcher
  --turned HOW             turn every shape about the up axis by an angle drawn for the pair: no (the default), quarters (a
                           multiple of 90°) or any
  --front HOW              what the matcher does about fronts, as --front of `match`: given (the default), likely or auto
  --role-weight W          compare the correspondences of least energy, by exact search, without roles and with roles of this
                           weight in the energy; 0, the default: compare matching by parts
  --pairs N                match at most N pairs of a category and folder (45), unless the folder has a pairs.json
  --trees N                trees in the forest of a category (80)
  --seed N                 of the trees and of the intervals (0)
  --cache FOLDER           keep structural graphs there
  --json FILE              write the evaluation, the weights and all pairs
  --model FILE             write the model that is learned from all shapes, with the weights of the terms and of
                           confidences fitted to these pairs; this needs 50 of them or more
)";

struct Options
{
  std::vector<std::string> folders, generated;
  std::string json, model, left_out = "shapes";
  std::size_t pairs = 45;
  std::optional<std::size_t> generated_shapes;
  Validation_options validation;
  Role_training_options training;
  cli::Common_options common;
};

/// The index of the value of an option among its known values.
int index_of(const std::string& option, const std::string& word, const std::vector<std::string>& known)
{
  const auto found = std::find(known.begin(), known.end(), word);
  if (found == known.end()) throw std::invalid_argument(option + " cannot be '" + word + "'");
  return int(found - known.begin());
}

Options parsed(int argc, char** argv)
{
  using benchmark::whole_number;
  benchmark::Command_line line(argc, argv);
  Options options;
  const std::map<std::string, std::function<void(const std::string&)>> known{
      {"--generated", [&](const std::string& word) { options.generated.push_back(word); }},
      {"--leave-out",
       [&](const std::string& word) {
         options.validation.left_out = Left_out(index_of("--leave-out", word, {"shapes", "sources", "category"}));
         options.left_out = word;
       }},
      {"--number-of-examples",
       [&](const std::string& word) { options.validation.examples = whole_number(word, "--number-of-examples"); }},
      {"--turned",
       [&](const std::string& word) {
         options.validation.turns = Validation_turns(index_of("--turned", word, {"no", "quarters", "any"}));
       }},
      {"--front",
       [&](const std::string& word) {
         options.validation.fronts = Validation_fronts(index_of("--front", word, {"given", "likely", "auto"}));
       }},
      {"--role-weight", [&](const std::string& word) { options.validation.role_weight = std::stod(word); }},
      {"--pairs", [&](const std::string& word) { options.pairs = whole_number(word, "--pairs"); }},
      {"--generated-shapes",
       [&](const std::string& word) { options.generated_shapes = whole_number(word, "--generated-shapes"); }},
      {"--generated-per-tree",
       [&](const std::string& word) {
         options.training.generated_per_tree = int(whole_number(word, "--generated-per-tree"));
       }},
      {"--trees", [&](const std::string& word) { options.training.trees = int(whole_number(word, "--trees")); }},
      {"--seed", [&](const std::string& word) { options.training.seed = whole_number(word, "--seed"); }},
      {"--cache", [&](const std::string& word) { options.common.cache = word; }},
      {"--model", [&](const std::string& word) { options.model = word; }},
      {"--json", [&](const std::string& word) { options.json = word; }}};
  while (!line.is_at_end()) {
    const std::string& word = line.word();
    if (word == "--told") {
      options.validation.category_known = true;
    } else if (const auto option = known.find(word); option != known.end()) {
      option->second(line.value());
    } else {
      benchmark::refuse_option(word);
      options.folders.push_back(word);
    }
  }
  if (options.folders.empty()) throw std::invalid_argument("no folder of labelled shapes");
  options.common.quiet = true;
  return options;
}

std::string decimals(double number)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.3f", number);
  return text;
}

/// The pairs that FOLDER/pairs.json lists: [[CATEGORY, SOURCE, TARGET], ...].
std::vector<Shape_pair> pairs_in(const std::string& file, const std::vector<cli::Labelled_model>& models,
                                 const std::string& folder)
{
  std::vector<Shape_pair> result;
  const Json list = Json::parse(std::ifstream(file));
  for (const auto& [category, source, target] : list.get<std::vector<std::array<std::string, 3>>>()) {
    const auto index = [&, &of = category](const std::string& name) {
      const auto found = std::find_if(models.begin(), models.end(), [&](const cli::Labelled_model& model) {
        return model.folder == folder && model.labels.category == of && model.labels.name == name;
      });
      if (found == models.end())
        throw Invalid_input(file + ": '" + name + "' is not a shape of the category '" + of + "'");
      return std::size_t(found - models.begin());
    };
    result.push_back({index(source), index(target)});
  }
  return result;
}

/// Pairs of shapes of one category and folder: those that the folder lists, or else at most `most` of each category,
/// chosen at even distances among all.
std::vector<Shape_pair> listed_pairs(const std::vector<cli::Labelled_model>& models, std::size_t most)
{
  std::set<std::string> folders;
  std::vector<Shape_pair> result;
  for (const auto& [folder, labels, graph, part_labels] : models) {
    if (!folders.insert(folder).second) continue;
    if (const std::string file = folder + "/pairs.json"; std::ifstream(file)) {
      cli::append(result, pairs_in(file, models, folder));
      continue;
    }
    std::map<std::string, std::vector<Shape_pair>> all;
    for (std::size_t i = 0; i < models.size(); ++i)
      for (std::size_t j = i + 1; j < models.size(); ++j)
        if (models[i].folder == folder && models[j].folder == folder &&
            models[i].labels.category == models[j].labels.category)
          all[models[i].labels.category].push_back({i, j});
    for (const auto& [category, pairs] : all) {
      const std::size_t count = std::min(most, pairs.size());
      for (std::size_t k = 0; k < count; ++k)
        result.push_back(pairs[k * pairs.size() / count]);
    }
  }
  return result;
}

/// Labelled shapes, the real ones first, and the validation of pairs of real ones.
struct Validated_shapes
{
  std::vector<cli::Labelled_model> models;
  std::vector<Validation_shape> shapes; // `models`, for the validation
  std::unique_ptr<Role_validation> validation;

  explicit Validated_shapes(const Options& options)
  {
    cli::append(models, cli::load_labelled_models(options.folders, options.common));
    const std::size_t number_of_real = models.size();
    const std::vector<Shape_pair> pairs = listed_pairs(models, options.pairs);
    if (pairs.empty()) throw Invalid_input(options.folders[0] + ": it takes two shapes of a category to match any");
    cli::append(models, cli::load_generated_models(options.generated, options.common));
    if (options.generated_shapes) keep_generated(number_of_real, *options.generated_shapes);
    for (const cli::Labelled_model& model : models) {
      const bool is_real = shapes.size() < number_of_real;
      shapes.push_back(
          {{&model.graph, model.labels.category, model.part_labels, is_real ? weight_of_real_shapes : 1, !is_real},
           is_real ? model.labels.source : "generated"});
    }
    validation = std::make_unique<Role_validation>(shapes, pairs, options.validation, options.training);
  }

  const std::vector<Validated_pair>& pairs() const { return validation->pairs(); }
  const std::string& category(const Validated_pair& pair) const { return shapes[pair.shapes[0]].labelled.category; }

  std::vector<Scored_correspondence> scores(Correspondence_score Validated_pair::*score) const
  {
    const auto name = [](const cli::Labelled_model& model) { return model.folder + '/' + model.labels.name; };
    std::vector<Scored_correspondence> result;
    for (const Validated_pair& pair : pairs())
      result.push_back({category(pair), name(models[pair.shapes[0]]), name(models[pair.shapes[1]]), pair.*score});
    return result;
  }

  /// Sum of `part` over sum of `whole` for pairs of category `wanted`; empty: mean over all categories. No value if
  /// `whole` is 0 for all pairs.
  std::optional<double> share(const std::string& wanted, const std::function<double(const Validated_pair&)>& part,
                              const std::function<double(const Validated_pair&)>& whole) const
  {
    std::map<std::string, std::array<double, 2>> sums;
    for (const Validated_pair& pair : pairs()) {
      if (whole(pair) == 0 || (!wanted.empty() && category(pair) != wanted)) continue;
      sums[category(pair)][0] += part(pair);
      sums[category(pair)][1] += whole(pair);
    }
    double result = 0;
    for (const auto& [name, sum] : sums)
      result += sum[0] / sum[1] / double(sums.size());
    return sums.empty() ? std::nullopt : std::optional<double>(result);
  }

private:
  // Keeps the first generated shapes of each category, the same number of each, `count` in all at most.
  void keep_generated(std::size_t number_of_real, std::size_t count)
  {
    std::map<std::string, std::size_t> counts;
    for (std::size_t i = number_of_real; i < models.size(); ++i)
      counts[models[i].labels.category] = 0;
    const std::size_t of_category = counts.empty() ? 0 : count / counts.size();
    const auto is_surplus = [&](const cli::Labelled_model& model) {
      return ++counts[model.labels.category] > of_category;
    };
    models.erase(std::remove_if(models.begin() + std::ptrdiff_t(number_of_real), models.end(), is_surplus),
                 models.end());
  }
};

double one(const Validated_pair&) { return 1; }

/// How well confidences predict which pairs of parts are right. Every pair of shapes of a category weighs the same.
struct Calibration
{
  bool has_confidences = false;
  double stated = 0, right = 0; // mean confidence of the pairs of parts, and share of those that are right
  double auc = 0;               // probability that a right pair has a higher confidence than a wrong one
  double sure_precision = 0;    // share of right pairs among those of a confidence of `sure` or more
  double sure_share = 0;        // share of pairs with a confidence of `sure` or more
  double error = 0;             // mean difference of confidence and share that is right, in ten classes of confidence
};
constexpr double sure = 0.7;

/// \param category empty: all categories, with equal weights
Calibration calibration_of(const Validated_shapes& set, const std::string& category)
{
  struct Weighted_pair
  {
    double confidence, weight;
    bool is_right;
  };
  std::map<std::string, double> pairs_of;
  for (const Validated_pair& pair : set.pairs())
    if (!pair.judged.empty() && (category.empty() || category == set.category(pair))) ++pairs_of[set.category(pair)];
  std::vector<Weighted_pair> all;
  for (const Validated_pair& pair : set.pairs())
    for (const Judged_pair& judged : pair.judged)
      if (const auto count = pairs_of.find(set.category(pair)); count != pairs_of.end())
        all.push_back({judged.confidence, 1 / (double(pairs_of.size()) * count->second * double(pair.judged.size())),
                       judged.is_right});
  std::sort(all.begin(), all.end(),
            [](const Weighted_pair& a, const Weighted_pair& b) { return a.confidence < b.confidence; });
  Calibration result;
  result.has_confidences = !all.empty();
  double wrong = 0, ordered = 0, sure_right = 0;
  std::array<double, 10> excess{}; // sum of confidence minus 1 or 0 (right or wrong), by class of confidence
  for (const Weighted_pair& pair : all) {
    result.stated += pair.weight * pair.confidence;
    excess[std::min(std::size_t(pair.confidence * 10), excess.size() - 1)] +=
        pair.weight * (pair.confidence - pair.is_right);
    (pair.is_right ? result.right : wrong) += pair.weight;
    if (pair.is_right) ordered += pair.weight * wrong;
    if (pair.confidence < sure) continue;
    result.sure_share += pair.weight;
    if (pair.is_right) sure_right += pair.weight;
  }
  for (double of_class : excess)
    result.error += std::abs(of_class);
  if (result.right * wrong > 0) result.auc = ordered / (result.right * wrong);
  if (result.sure_share > 0) result.sure_precision = sure_right / result.sure_share;
  return result;
}

/// Scores of a category, or means of all, by geometry alone and with roles; `gain`: paired differences of the two.
struct Row
{
  std::string name, category; // `category` is empty for the mean
  Mean_estimates geometric, joined, gain;
};

std::vector<Row> rows_of(const Validated_shapes& set, std::uint64_t seed)
{
  const std::vector<Scored_correspondence> without = set.scores(&Validated_pair::geometric),
                                           with = set.scores(&Validated_pair::joined);
  const Estimated_scores geometric = mean_estimates(without, {}, seed), joined = mean_estimates(with, {}, seed),
                         gain = mean_estimates(with, without, seed);
  std::vector<Row> result;
  for (std::size_t c = 0; c < gain.categories.size(); ++c) {
    const std::string& name = gain.categories[c].first;
    result.push_back(
        {name, name, geometric.categories[c].second, joined.categories[c].second, gain.categories[c].second});
  }
  result.push_back({"mean", "", geometric.mean, joined.mean, gain.mean});
  return result;
}

void write_table(const Validated_shapes& set, const std::vector<Row>& rows)
{
  std::vector<std::vector<std::string>> table{{"category",   "pairs",  "geometry P", "R",     "F1",    "with roles P",
                                               "R",          "F1",     "95 %",       "gain",  "95 %",  "stated",
                                               "right",      "AUC",    "P sure",     "share", "error", "front",
                                               "sure front", "labels", "with roles"}};
  const auto interval = [](const Estimate& e) { return decimals(e.low) + ".." + decimals(e.high); };
  const auto text = [](const std::optional<double>& number) { return number ? decimals(*number) : "-"; };
  for (const Row& row : rows) {
    std::vector<std::string> cells{row.name, std::to_string(row.geometric.correspondences)};
    for (const Mean_estimates* score : {&row.geometric, &row.joined})
      for (const Estimate* estimate : {&score->precision, &score->recall, &score->f1})
        cells.push_back(decimals(estimate->mean));
    cells.insert(cells.end(), {interval(row.joined.f1), decimals(row.gain.f1.mean), interval(row.gain.f1)});
    const Calibration found = calibration_of(set, row.category);
    for (double value : {found.stated, found.right, found.auc, found.sure_precision, found.sure_share, found.error})
      cells.push_back(found.has_confidences ? decimals(value) : "-");
    for (const auto fronts : {&Front_count::possible, &Front_count::sure})
      cells.push_back(text(set.share(
          row.category, [&](const Validated_pair& pair) { return pair.fronts.*fronts; },
          [](const Validated_pair& pair) { return pair.fronts.shapes; })));
    for (const auto labels : {&Validated_pair::labels_by_geometry, &Validated_pair::labels_joined})
      cells.push_back(text(set.share(
          row.category, [&](const Validated_pair& pair) { return pair.*labels; }, one)));
    table.push_back(std::move(cells));
  }
  cli::write_table(std::cout, table);
}

Json json_of(const Mean_estimates& score)
{
  Json result;
  for (const auto& [name, e] :
       {std::pair("precision", score.precision), std::pair("recall", score.recall), std::pair("f1", score.f1)})
    result[name] = {{"mean", e.mean}, {"low", e.low}, {"high", e.high}};
  return result;
}

Json json_of(const Pair_weights& w)
{
  return {{"same_label", w[SAME_LABEL]},         {"same_role", w[SAME_ROLE]}, {"votes_agree", w[VOTES_AGREE]},
          {"geometric_pair", w[GEOMETRIC_PAIR]}, {"excess", w[EXCESS]},       {"constant", w[CONSTANT]}};
}

Json json_of(const Confidence_weights& w) { return {{"slope", w[SLOPE]}, {"offset", w[OFFSET]}}; }

Json json_of(const Validated_shapes& set, const std::vector<Row>& rows, const std::string& left_out)
{
  const auto labels = [&](const Row& row, double Validated_pair::*share) {
    return *set.share(
        row.category, [&](const Validated_pair& pair) { return pair.*share; }, one);
  };
  Json result{{"format", "shape_correspondence/role_evaluation"}, {"version", 1}, {"left_out", left_out}};
  for (const Row& row : rows)
    result["categories"].push_back({{"category", row.name},
                                    {"pairs", row.geometric.correspondences},
                                    {"geometry", json_of(row.geometric)},
                                    {"with_roles", json_of(row.joined)},
                                    {"gain", json_of(row.gain)},
                                    {"labels", labels(row, &Validated_pair::labels_by_geometry)},
                                    {"labels_with_roles", labels(row, &Validated_pair::labels_joined)}});
  result["weights"] = json_of(set.validation->weights());
  const Role_model model = set.validation->fitted_model();
  for (const Category_roles& fitted : Role_model_access::data(model).categories) {
    Json& entry = result["fitted"][fitted.name];
    entry["weights"] = json_of(fitted.weights);
    entry["confidence"] = json_of(fitted.confidence);
    entry["geometric_confidence"] = json_of(fitted.geometric_confidence);
  }
  for (const Validated_pair& pair : set.pairs()) {
    Json entry{{"category", set.category(pair)},
               {"source", set.models[pair.shapes[0]].labels.file},
               {"target", set.models[pair.shapes[1]].labels.file},
               {"category_found", pair.category},
               {"geometry", pair.geometric.f1()},
               {"with_roles", pair.joined.f1()},
               {"distances", pair.distances},
               {"confidences", Json::array()}};
    for (const Judged_pair& judged : pair.judged)
      entry["confidences"].push_back(Json::array({judged.confidence, judged.is_right, judged.has_one_role}));
    result["pairs"].push_back(std::move(entry));
  }
  return result;
}

} // namespace

int main(int argc, char** argv)
{
  if (argc == 2 && (std::string(argv[1]) == "--help" || std::string(argv[1]) == "-h")) {
    std::cout << help_text;
    return 0;
  }
  try {
    const Options options = parsed(argc, argv);
    const Validated_shapes set(options);
    const std::vector<Row> rows = rows_of(set, options.training.seed);
    write_table(set, rows);
    if (!options.json.empty()) std::ofstream(options.json) << json_of(set, rows, options.left_out).dump(1) << '\n';
    if (!options.model.empty()) IO::write_role_model(options.model, set.validation->fitted_model());
  } catch (const std::invalid_argument& error) {
    std::cerr << "validate_roles: " << error.what() << " (see --help)\n";
    return bad_usage;
  } catch (const std::exception& error) {
    std::cerr << "validate_roles: " << error.what() << '\n';
    return bad_input;
  }
}

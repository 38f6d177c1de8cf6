// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/collection_shapes.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/labelled_models.h"
#include "cli/outputs.h"
#include "cli/predicted_labels.h"
#include "cli/run_report.h"
#include "cli/text_table.h"
#include "cli/thread_limit.h"
#include "io/Json.h"
#include "matching/cross_validate_roles.h"
#include "matching/mean_differences.h"

#include <CGAL/Shape_correspondence/IO/role_model.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <iostream>
#include <map>

namespace CGAL::Shape_correspondence::cli {

namespace po = boost::program_options;
using namespace internal;

namespace {

const char* const help_text =
    R"(Usage: shape_correspondence roles train FOLDER... --output MODEL [options]
       shape_correspondence roles evaluate FOLDER... [options]
       shape_correspondence roles predict SHAPE [options]

Learns the roles of parts, such as the legs and the seat of a chair, from labelled shapes.

  train     learns a model. The weights of predicted labels and of the geometric match are fitted to pairs of shapes
            that were left out of the training; this needs 50 pairs of shapes or more
  evaluate  measures by how much roles improve the matching of shapes that were left out of the training
  predict   prints the roles of the parts of a shape, as the command label does

FOLDER has CATEGORY/SHAPE/labels.json and CATEGORY/SHAPE/parts, one mesh file for each part. labels.json gives the coarse
label of every part, which is its role:

  {"category": "chair", "parts": [{"name": "part_0", "coarse": "leg"}, {"name": "part_1", "coarse": "seat"}]}

All shapes must be upright and face +z. A category should have at least five shapes; twenty or more are better.

Examples: shape_correspondence roles train my_shapes --output my.roles --cache graphs
          shape_correspondence roles predict chair.obj --roles my.roles

)";

struct Roles_options
{
  std::vector<std::string> generated;
  std::string output, manifest, date, model, category;
  bool turned = false;
  std::string leave_out = "shapes";
  int shown_examples = 0;
  std::string examples;
  bool told = false;
  double role_weight = 0;
  int pairs = 45;
  Role_training_options training;
};

po::options_description roles_options(Roles_options& roles, Common_options& common)
{
  po::options_description result = option_group("Options of roles");
  auto add = result.add_options();
  add("output,o", po::value(&roles.output)->value_name("MODEL"), "train: write the model to this file");
  add("manifest", po::value(&roles.manifest)->value_name("FILE"),
      "train: write the training shapes and the accuracy of the model as JSON; - is standard output");
  add("date", po::value(&roles.date)->value_name("DATE"), "train: date to put into the manifest");
  add("generated", po::value(&roles.generated)->value_name("FOLDER"),
      "train, evaluate: further labelled shapes that are generated; they have a third of the weight of real ones and "
      "are "
      "never left out. Can be repeated");
  add("leave-out", po::value(&roles.leave_out)->value_name("WHAT")->default_value(roles.leave_out),
      "evaluate: what is left out of the training for a pair of shapes: shapes (the two), sources (all shapes with "
      "their `source` in labels.json) or category (all shapes of their category)");
  add("examples", po::value(&roles.examples)->value_name("FOLDER"),
      "predict: labelled shapes that the model learns in addition, as of `match`");
  add("number-of-examples", po::value(&roles.shown_examples)->value_name("N"),
      "evaluate: the training sees at most N shapes of the pair's category that are not generated, drawn for every "
      "pair; with --leave-out category, no others of the category. Default: all that are not left out");
  add("told", po::bool_switch(&roles.told), "evaluate: give the category to the matcher, as by --category");
  add("turned", po::bool_switch(&roles.turned),
      "evaluate: turn every shape about the up axis by an angle drawn for the pair, and let the matcher find the "
      "fronts, "
      "as by --front auto");
  add("role-weight", number(roles.role_weight)->value_name("W"),
      "evaluate: compare the correspondences of least energy, by exact search, without roles and with roles of this "
      "weight in the energy; 0: compare matching by parts");
  add("pairs", number(roles.pairs)->value_name("N"),
      "train, evaluate: match at most N pairs of a category and folder, unless the folder has a pairs.json: "
      "[[CATEGORY, SOURCE, TARGET], ...]");
  add("trees", number(roles.training.trees)->value_name("N"), "train, evaluate: trees in the forest of a category");
  add("roles", po::value(&roles.model)->value_name("MODEL"),
      "predict: the role model; default: the one that comes with the program");
  add("category", po::value(&roles.category)->value_name("NAME"),
      "predict: the category of the shape; default: the one whose labelled parts are most similar to its parts");
  add("json", po::value(&common.json)->value_name("FILE"),
      "evaluate, predict: write the result as JSON; - is standard output");
  return result;
}

Left_out left_out(const std::string& word)
{
  check_word("leave-out", word, {"shapes", "sources", "category"});
  return word == "shapes" ? Left_out::SHAPES : word == "sources" ? Left_out::SOURCES : Left_out::CATEGORY;
}

Validation_options validation_options(const Roles_options& roles)
{
  Validation_options result;
  result.left_out = left_out(roles.leave_out);
  if (roles.shown_examples > 0) result.examples = std::size_t(roles.shown_examples);
  result.category_is_told = roles.told;
  result.role_weight = roles.role_weight;
  result.is_turned = roles.turned;
  return result;
}

std::string fixed(double number)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.3f", number);
  return text;
}

// Shapes that roles are learned from, the real ones first, and pairs of real ones.
struct Training_set
{
  std::vector<Labelled_model> models;
  std::vector<Validation_shape> shapes;
  std::vector<Validation_pair> pairs;
  std::size_t number_of_real = 0;

  Training_set(const std::vector<std::string>& folders, const Roles_options& roles, const Common_options& common)
  {
    add(folders, common);
    number_of_real = models.size();
    pairs = listed_pairs(models, std::size_t(roles.pairs));
    add(roles.generated, common);
    for (const Labelled_model& model : models) {
      const bool is_real = shapes.size() < number_of_real;
      const double weight = is_real ? weight_of_real_shapes : 1;
      shapes.push_back({{&model.graph, model.labels.category, model.part_labels, weight},
                        is_real ? model.labels.source : "generated",
                        !is_real});
    }
  }

private:
  void add(const std::vector<std::string>& folders, const Common_options& common)
  {
    for (const std::string& folder : folders)
      for (Labelled_model& model : load_labelled_models(folder, common))
        models.push_back(std::move(model));
  }
};

using Score_of = std::function<const Correspondence_score&(const Validated_pair&)>;

std::vector<Scored_correspondence> scores_of(const Training_set& set, const Role_validation& validation,
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

// By geometry alone, with roles, and the paired difference.
struct Evaluations
{
  Evaluation geometric, joined, gain;

  Evaluations(const Training_set& set, const Role_validation& validation, const Common_options& common)
  {
    const std::vector<Scored_correspondence> without = scores_of(set, validation, geometric_score),
                                             with = scores_of(set, validation, joined_score);
    Evaluation_options options;
    options.seed = std::uint64_t(common.seed);
    geometric = mean_scores(without, options);
    joined = mean_scores(with, options);
    gain = mean_differences(with, without, options);
  }
};

std::string interval(const Estimate& estimate) { return fixed(estimate.low) + ".." + fixed(estimate.high); }

// How well confidences tell right from wrong. Every pair of shapes of a category weighs the same.
struct Calibration
{
  double stated = 0, right = 0; // mean confidence of the pairs of parts, and share of those that are right
  double auc = 0;               // how often a pair that is right has more confidence than one that is wrong
  double sure_precision = 0;    // share that is right of those of a confidence of `sure` or more
  double sure_share = 0;        // and how many of all they are
};
constexpr double sure = 0.7;

// \param category empty: all, of which each weighs the same
Calibration calibration_of(const Training_set& set, const Role_validation& validation, const std::string& category)
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

// How often the front of a shape is among those that are thought possible, or the only one; - where no category was
// told.
// \param category empty: the mean of all
std::string share_of_fronts(const Training_set& set, const Role_validation& validation, const std::string& category,
                            int Front_count::*fronts)
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
  return counts.empty() ? "-" : fixed(sum / double(counts.size()));
}

// The mean of the pairs, every category with the same weight.
// \param category empty: all
double mean_share(const Training_set& set, const Role_validation& validation, const std::string& category,
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

void print(const Training_set& set, const Role_validation& validation, const Common_options& common)
{
  const Evaluations found(set, validation, common);
  std::vector<std::vector<std::string>> rows{{"category",     "pairs",  "geometry P", "R",      "F1",
                                              "with roles P", "R",      "F1",         "95 %",   "gain",
                                              "95 %",         "stated", "right",      "AUC",    "P sure",
                                              "share",        "front",  "sure front", "labels", "with roles"}};
  const auto add_row = [&](const std::string& name, const Mean_score& without, const Mean_score& with,
                           const Mean_score& gain) {
    rows.push_back({name, std::to_string(without.correspondences)});
    for (const Mean_score* score : {&without, &with})
      for (const Estimate* estimate : {&score->precision, &score->recall, &score->f1})
        rows.back().push_back(fixed(estimate->mean));
    const Calibration confidences = calibration_of(set, validation, name == "mean" ? "" : name);
    for (const std::string& text : {interval(with.f1), fixed(gain.f1.mean), interval(gain.f1)})
      rows.back().push_back(text);
    for (double value :
         {confidences.stated, confidences.right, confidences.auc, confidences.sure_precision, confidences.sure_share})
      rows.back().push_back(fixed(value));
    for (const auto fronts : {&Front_count::possible, &Front_count::sure})
      rows.back().push_back(share_of_fronts(set, validation, name == "mean" ? "" : name, fronts));
    for (const auto labels : {&Validated_pair::labels_by_geometry, &Validated_pair::labels_joined})
      rows.back().push_back(fixed(mean_share(set, validation, name == "mean" ? "" : name, labels)));
  };
  for (std::size_t c = 0; c < found.gain.categories.size(); ++c)
    add_row(found.gain.categories[c].first, found.geometric.categories[c].second, found.joined.categories[c].second,
            found.gain.categories[c].second);
  add_row("mean", found.geometric.mean, found.joined.mean, found.gain.mean);
  write_table(std::cout, rows);
}

// Of the terms of a pair, see `Pair_term`.
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

// Of the confidence of a pair, see `Confidence_term`.
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

IO::Json json_of(const Training_set& set, const Role_validation& validation, const Common_options& common)
{
  const Evaluations found(set, validation, common);
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

IO::Json pairs_json(const Training_set& set, const Role_validation& validation)
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

void evaluate(const std::vector<std::string>& folders, const Roles_options& roles, const Common_options& common)
{
  check_outputs({common.json}, {});
  const Training_set set(folders, roles, common);
  if (set.pairs.empty()) throw Invalid_input(folders[0] + ": it takes two shapes of a category to match any");
  const Role_validation validation(set.shapes, set.pairs, validation_options(roles), roles.training);
  write_output(common.json, [&](std::ostream& out) {
    IO::Json document;
    document["format"] = "shape_correspondence/role_evaluation";
    document["version"] = 1;
    document["left_out"] = roles.leave_out;
    document["categories"] = json_of(set, validation, common);
    document["weights"] = json_of(validation.weights());
    document["pairs"] = pairs_json(set, validation);
    document.write(out);
  });
  if (common.prints_table()) print(set, validation, common);
}

// What a model was learned from, and how good it is.
IO::Json manifest(const Training_set& set, const Role_validation& validation, const Role_model& model,
                  const Roles_options& roles, const Common_options& common)
{
  IO::Json result;
  result["format"] = "shape_correspondence/role_manifest";
  result["version"] = 1;
  if (!roles.date.empty()) result["date"] = roles.date;
  result["seed"] = roles.training.seed;
  result["trees"] = roles.training.trees;
  result["categories"] = IO::Json::array();
  for (const std::string& category : model.categories()) {
    IO::Json entry;
    entry["category"] = category;
    entry["roles"] = IO::Json(model.roles(category));
    const Category_roles& learned = model.data().categories[model.data().index(category)];
    entry["weights"] = json_of(learned.weights);
    entry["confidence"] = json_of(learned.confidence);
    result["categories"].push_back(std::move(entry));
  }
  result["weights"] = json_of(validation.weights());
  // Of shapes of either kind that the training did not see
  if (!set.pairs.empty()) result["left_out_shapes"] = json_of(set, validation, common);
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

void train(const std::vector<std::string>& folders, const Roles_options& roles, const Common_options& common)
{
  if (roles.output.empty()) throw Usage_error("'roles train' needs --output MODEL");
  check_outputs({roles.output, roles.manifest}, {});
  const Training_set set(folders, roles, common);
  const Role_validation validation(set.shapes, set.pairs, {}, roles.training);
  const Role_model model = validation.model();
  IO::write_role_model(roles.output, model);
  write_output(roles.manifest, [&](std::ostream& out) { manifest(set, validation, model, roles, common).write(out); });
  if (common.prints_table() && roles.manifest != "-" && !set.pairs.empty()) print(set, validation, common);
}

/// Options that only some of the actions have.
void refuse_options_of_other_actions(const std::string& action, const po::variables_map& values)
{
  const std::pair<const char*, std::vector<std::string>> actions_of[] = {{"output", {"train"}},
                                                                         {"manifest", {"train"}},
                                                                         {"date", {"train"}},
                                                                         {"generated", {"train", "evaluate"}},
                                                                         {"leave-out", {"evaluate"}},
                                                                         {"number-of-examples", {"evaluate"}},
                                                                         {"examples", {"predict"}},
                                                                         {"told", {"evaluate"}},
                                                                         {"turned", {"evaluate"}},
                                                                         {"role-weight", {"evaluate"}},
                                                                         {"pairs", {"train", "evaluate"}},
                                                                         {"trees", {"train", "evaluate"}},
                                                                         {"roles", {"predict"}},
                                                                         {"category", {"predict"}},
                                                                         {"json", {"evaluate", "predict"}}};
  for (const auto& [option, actions] : actions_of)
    if (is_given(values, option) && std::find(actions.begin(), actions.end(), action) == actions.end())
      throw Usage_error("--" + std::string(option) + " has no effect on 'roles " + action + "'");
}

struct Variables
{
  Common_options common;
  Roles_options roles;
};

po::options_description all_options(Variables& v)
{
  po::options_description result;
  result.add(roles_options(v.roles, v.common)).add(model_options(v.common)).add(common_options(v.common));
  return result;
}

} // namespace

Command_help help_of_roles()
{
  static Variables unused;
  return {help_text, all_options(unused)};
}

void run_roles(const std::vector<std::string>& arguments)
{
  Variables variables;
  Common_options& common = variables.common;
  Roles_options& roles = variables.roles;
  const Arguments parsed = parse(arguments, all_options(variables), 2, any_number);
  if (parsed.help) return write_help(std::cout, command_of("roles"));
  const Run_report report(common);
  check(common);
  check_at_least("trees", roles.training.trees, 1);
  check_at_least("pairs", roles.pairs, 1);
  if (!(roles.role_weight >= 0) || std::isinf(roles.role_weight))
    throw Usage_error("--role-weight must be finite and not negative");
  if (roles.turned && roles.role_weight > 0) throw Usage_error("--turned has no effect with --role-weight");
  if (is_given(parsed.values, "number-of-examples")) check_at_least("number-of-examples", roles.shown_examples, 1);
  roles.training.seed = std::uint64_t(common.seed);
  const Thread_limit limit(common.threads);
  const std::string action = parsed.inputs[0];
  const std::vector<std::string> inputs(parsed.inputs.begin() + 1, parsed.inputs.end());
  const std::vector<std::string> known{"train", "evaluate", "predict"};
  if (std::find(known.begin(), known.end(), action) == known.end())
    throw Usage_error("there is no 'roles " + action + "'; known are: train, evaluate, predict");
  refuse_options_of_other_actions(action, parsed.values);
  if (action == "train")
    train(inputs, roles, common);
  else if (action == "evaluate")
    evaluate(inputs, roles, common);
  else if (inputs.size() == 1)
    label_shape(inputs[0], {roles.model, roles.examples, roles.category}, common.json, common);
  else
    throw Usage_error("'roles predict' takes one shape");
}

} // namespace CGAL::Shape_correspondence::cli

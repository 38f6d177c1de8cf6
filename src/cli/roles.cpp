// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/for_each_index.h"
#include "cli/Command.h"
#include "cli/evaluate.h"
#include "cli/labels.h"
#include "cli/run.h"
#include "cli/text.h"
#include "matching/mean_differences.h"
#include "roles/Role_model_data.h"

#include <CGAL/Shape_correspondence/IO/role_model.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <algorithm>
#include <iostream>

namespace CGAL::Shape_correspondence::cli {

using namespace internal;

namespace {

const char* const roles_help =
    R"(Usage: shape_correspondence roles train FOLDER... --output MODEL [options]
       shape_correspondence roles evaluate FOLDER... [options]
       shape_correspondence roles predict SHAPE [options]

Learns the roles of parts, such as the legs and the seat of a chair, from labelled shapes.

  train     learns a model. The weights of predicted labels and of the geometric match are fitted to pairs of shapes,
            each matched as by a model that has seen neither of them; this needs 50 pairs of shapes or more
  evaluate  measures by how much a model improves the matching of labelled shapes, which should be others than those that
            it was learned from
  predict   prints the roles of the parts of a shape, as the command label does

FOLDER has CATEGORY/SHAPE/labels.json and CATEGORY/SHAPE/parts, one mesh file for each part. labels.json gives the coarse
label of every part, which is its role:

  {"category": "chair", "parts": [{"name": "part_0", "coarse": "leg"}, {"name": "part_1", "coarse": "seat"}]}

All shapes must be upright and face +z. A category should have at least five shapes; twenty or more are better.

Examples: shape_correspondence roles train my_shapes --output my.roles --cache graphs
          shape_correspondence roles evaluate other_shapes --roles my.roles --cache graphs
          shape_correspondence roles predict chair.obj --roles my.roles

)";

struct Roles_options
{
  Role_training training;
  std::string output, manifest, date;
  Label_options label; // predict, evaluate: the model
};

void add_weights(const Match_weights& weights, IO::Json& result)
{
  const char* const names[] = {"same_label", "same_role", "votes_agree", "geometric_pair", "excess", "constant"};
  for (Eigen::Index term = 0; term < PAIR_TERM_COUNT; ++term)
    result["weights"][names[term]] = weights.weights[term];
  for (const auto& [name, confidence] :
       {std::pair("confidence", weights.confidence), std::pair("geometric_confidence", weights.geometric_confidence)})
    result[name] = {{"slope", confidence[SLOPE]}, {"offset", confidence[OFFSET]}};
}

/// What a model was learned from.
IO::Json manifest_json(const Trained_roles& trained, const Roles_options& roles)
{
  IO::Json result;
  result["format"] = "shape_correspondence/role_manifest";
  result["version"] = 1;
  if (!roles.date.empty()) result["date"] = roles.date;
  result["seed"] = roles.training.options.seed;
  result["trees"] = roles.training.options.trees;
  result["categories"] = IO::Json::array();
  for (const Category_roles& learned : Role_model_access::data(trained.model).categories) {
    IO::Json entry = {{"category", learned.name}, {"roles", learned.roles}};
    add_weights(learned, entry);
    result["categories"].push_back(std::move(entry));
  }
  result["generated_shapes"] = trained.models.size() - trained.number_of_real;
  result["shapes"] = IO::Json::array();
  for (std::size_t i = 0; i < trained.number_of_real; ++i) {
    const IO::Labelled_shape& shape = trained.models[i].labels;
    result["shapes"].push_back(
        {{"category", shape.category}, {"name", shape.name}, {"source", shape.source}, {"license", shape.license}});
  }
  return result;
}

void train(const Roles_options& roles, const Common_options& common)
{
  const Trained_roles trained = train_roles(roles.training, common);
  IO::write_role_model(roles.output, trained.model);
  write_output(roles.manifest, [&](std::ostream& out) { manifest_json(trained, roles).write(out); });
  if (common.quiet || roles.manifest == "-") return;
  std::vector<std::vector<std::string>> rows{{"category", "shapes", "roles"}};
  for (const std::string& category : trained.model.categories()) {
    const auto shapes = std::count_if(trained.models.begin(), trained.models.end(),
                                      [&](const Labelled_model& model) { return model.labels.category == category; });
    rows.push_back({category, std::to_string(shapes), listed(trained.model.roles(category))});
  }
  write_table(std::cout, rows);
}

/// Scores of pairs of labelled shapes, matched by geometry alone and with roles; the gain is paired.
struct Evaluated_roles
{
  std::vector<Scored_correspondence> geometry, with_roles; // by pair
  Evaluation mean_geometry, mean_with_roles, gain;
};

Evaluated_roles evaluated(const std::vector<Labelled_model>& models,
                          const std::vector<std::array<std::size_t, 2>>& pairs,
                          const std::shared_ptr<const Role_model>& model, std::uint64_t seed)
{
  Evaluated_roles result;
  result.geometry.resize(pairs.size());
  result.with_roles.resize(pairs.size());
  const auto prepared = [](const Labelled_model& labelled) { return Prepared_shape(labelled.graph); };
  const std::vector<Prepared_shape> shapes = mapped(models, prepared);
  for_each_index(pairs.size(), true, [&](std::size_t i) {
    const Labelled_model &source = models[pairs[i][0]], &target = models[pairs[i][1]];
    const Ground_truth truth = ground_truth(source.part_labels, target.part_labels);
    const auto scored = [&](const std::shared_ptr<const Role_model>& roles) {
      Search_options options;
      options.roles = roles;
      const Part_pairs found =
          part_pairs(Correspondence_finder(shapes[pairs[i][0]], options)(shapes[pairs[i][1]]).pairs);
      return Scored_correspondence{source.labels.category, source.labels.file, target.labels.file,
                                   evaluate_correspondence(found, truth)};
    };
    result.geometry[i] = scored(nullptr);
    result.with_roles[i] = scored(model);
  });
  Evaluation_options options;
  options.seed = seed;
  result.mean_geometry = mean_scores(result.geometry, options);
  result.mean_with_roles = mean_scores(result.with_roles, options);
  result.gain = mean_differences(result.with_roles, result.geometry, options);
  return result;
}

/// The scores of a category, or the mean.
struct Score_row
{
  std::string category;
  Mean_score geometry, with_roles, gain;
};

std::vector<Score_row> rows_of(const Evaluated_roles& found)
{
  std::vector<Score_row> rows;
  for (std::size_t c = 0; c < found.gain.categories.size(); ++c)
    rows.push_back({found.gain.categories[c].first, found.mean_geometry.categories[c].second,
                    found.mean_with_roles.categories[c].second, found.gain.categories[c].second});
  rows.push_back({"mean", found.mean_geometry.mean, found.mean_with_roles.mean, found.gain.mean});
  return rows;
}

std::string interval_text(const Estimate& estimate) { return decimals(estimate.low) + ".." + decimals(estimate.high); }

void write_evaluation_table(std::ostream& out, const Evaluated_roles& found)
{
  std::vector<std::vector<std::string>> rows{
      {"category", "pairs", "geometry P", "R", "F1", "with roles P", "R", "F1", "95 %", "gain", "95 %"}};
  for (const auto& [category, geometry, with_roles, gain] : rows_of(found)) {
    rows.push_back({category, std::to_string(geometry.correspondences)});
    for (const Mean_score* score : {&geometry, &with_roles})
      for (const Estimate* estimate : {&score->precision, &score->recall, &score->f1})
        rows.back().push_back(decimals(estimate->mean));
    append(rows.back(), {interval_text(with_roles.f1), decimals(gain.f1.mean), interval_text(gain.f1)});
  }
  write_table(out, rows);
}

IO::Json scores_json(const Mean_score& score)
{
  return {{"precision", estimate_json(score.precision)},
          {"recall", estimate_json(score.recall)},
          {"f1", estimate_json(score.f1)}};
}

IO::Json evaluation_json(const Evaluated_roles& found)
{
  const auto of_category = [](const Score_row& row) -> IO::Json {
    return {{"category", row.category},
            {"pairs", row.geometry.correspondences},
            {"geometry", scores_json(row.geometry)},
            {"with_roles", scores_json(row.with_roles)},
            {"gain", scores_json(row.gain)}};
  };
  IO::Json pairs = IO::Json::array();
  for (std::size_t i = 0; i < found.geometry.size(); ++i) {
    const Scored_correspondence& geometry = found.geometry[i];
    pairs.push_back({{"category", geometry.category},
                     {"source", geometry.source},
                     {"target", geometry.target},
                     {"geometry", geometry.score.f1()},
                     {"with_roles", found.with_roles[i].score.f1()}});
  }
  return {{"format", "shape_correspondence/role_evaluation"},
          {"version", 2},
          {"categories", mapped(rows_of(found), of_category)},
          {"pairs", pairs}};
}

void evaluate(const std::vector<std::string>& folders, const Roles_options& roles, const Common_options& common)
{
  const std::shared_ptr<const Role_model> model = role_model_of(roles.label.roles);
  const std::vector<Labelled_model> models = load_labelled_models(folders, common);
  const auto pairs = listed_pairs(models, roles.training.most_pairs);
  if (pairs.empty()) throw Invalid_input(folders[0] + ": it takes two shapes of a category to match any; add some");
  const Evaluated_roles found = evaluated(models, pairs, model, roles.training.options.seed);
  write_output(common.json, [&](std::ostream& out) { evaluation_json(found).write(out); });
  if (common.prints_table()) write_evaluation_table(std::cout, found);
}

class Roles_command : public Command
{
public:
  Roles_command() : Command(roles_help, 2, any_number)
  {
    Option_table::Group add = table.group("Options of roles");
    const std::vector<std::string> train{"train"}, predict{"predict"};
    add("output,o", "MODEL", &roles_.output, "train: write the model to this file").output().only_for(train);
    add("manifest", "FILE", &roles_.manifest,
        "train: write the training shapes and the weights of the model as JSON; - is standard output")
        .output()
        .only_for(train);
    add("date", "DATE", &roles_.date, "train: date to put into the manifest").only_for(train);
    add("generated", "FOLDER", &roles_.training.generated,
        "train: further labelled shapes that are generated; they have a third of the weight of real ones and are in no "
        "pair. Can be repeated")
        .only_for(train);
    add("pairs", "N", &roles_.training.most_pairs,
        "train, evaluate: match at most N pairs of a category and folder, unless the folder has a pairs.json: "
        "[[CATEGORY, SOURCE, TARGET], ...]")
        .at_least(1)
        .only_for({"train", "evaluate"});
    add("trees", "N", &roles_.training.options.trees, "train: trees in the forest of a category")
        .at_least(1)
        .only_for(train);
    add("roles", "MODEL", &roles_.label.roles,
        "evaluate, predict: the role model; default: the one that comes with the program")
        .input()
        .only_for({"evaluate", "predict"});
    add("examples", "FOLDER", &roles_.label.examples,
        "predict: labelled shapes that the model learns in addition, as of `match`")
        .input()
        .only_for(predict);
    add("category", "NAME", &roles_.label.category,
        "predict: the category of the shape; default: the one whose labelled parts are most similar to its parts")
        .only_for(predict);
    add("json", "FILE", &common.json, "evaluate, predict: write the result as JSON; - is standard output")
        .output()
        .only_for({"evaluate", "predict"});
    add_model_options(table, common);
    add_common_options(table, common);
  }

private:
  void check() override
  {
    action_ = inputs[0];
    inputs.erase(inputs.begin());
    const std::vector<std::string> known{"train", "evaluate", "predict"};
    if (std::find(known.begin(), known.end(), action_) == known.end())
      throw Usage_error("there is no 'roles " + action_ + "'; known are: train, evaluate, predict");
    table.refuse_other_modes(action_, "on 'roles " + action_ + "'");
    if (action_ == "train" && roles_.output.empty()) throw Usage_error("'roles train' needs --output MODEL");
    if (action_ == "predict" && inputs.size() != 1) throw Usage_error("'roles predict' takes one shape");
    roles_.training.folders = inputs;
    roles_.training.options.seed = std::uint64_t(common.seed);
  }

  void work() override
  {
    if (action_ == "train")
      train(roles_, common);
    else if (action_ == "evaluate")
      evaluate(inputs, roles_, common);
    else
      label_shape(inputs[0], roles_.label, common.json, common);
  }

  Roles_options roles_;
  std::string action_;
};

} // namespace

std::unique_ptr<Command> roles_command() { return std::make_unique<Roles_command>(); }

} // namespace CGAL::Shape_correspondence::cli

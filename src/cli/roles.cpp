// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/Command.h"
#include "cli/labels.h"
#include "cli/run.h"
#include "cli/text.h"
#include "io/write/Json.h"
#include "roles/Role_model_data.h"

#include <CGAL/Shape_correspondence/IO/role_model.h>

#include <algorithm>
#include <iostream>

namespace CGAL::Shape_correspondence::cli {

using namespace internal;

namespace {

const char* const roles_help =
    R"(Usage: shape_correspondence roles train FOLDER... --output MODEL [options]

Learns a model of the roles of parts, such as the legs and the seat of a chair, from labelled shapes. `match`, `label` and
others take it as --roles.

FOLDER has CATEGORY/SHAPE/labels.json and CATEGORY/SHAPE/parts, one mesh file for each part. labels.json gives the coarse
label of every part, which is its role:

  {"category": "chair", "parts": [{"name": "part_0", "coarse": "leg"}, {"name": "part_1", "coarse": "seat"}]}

All shapes must be upright and face +z. A category should have at least five shapes; twenty or more are better.

Examples: shape_correspondence roles train my_shapes --output my.roles --cache graphs
          shape_correspondence label chair.obj --roles my.roles

)";

struct Roles_options
{
  Role_training training;
  std::string output, manifest, date;
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

/// A description of the data that a role model was learned from.
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

class Roles_command : public Command
{
public:
  Roles_command() : Command(roles_help, 2, any_number)
  {
    Option_table::Group add = table.group("Options of roles");
    add("output,o", "MODEL", &roles_.output, "write the model to this file").output();
    add("manifest", "FILE", &roles_.manifest,
        "write the training shapes and the weights of the model as JSON; - is standard output")
        .output();
    add("date", "DATE", &roles_.date, "date to put into the manifest");
    add("generated", "FOLDER", &roles_.training.generated,
        "further labelled shapes that are generated; they have a third of the weight of real ones, and a tree sees 40 "
        "of a "
        "category at most. Can be repeated");
    add("trees", "N", &roles_.training.options.trees, "trees in the forest of a category").at_least(1);
    add_model_options(table, common);
    add_common_options(table, common);
  }

private:
  void check() override
  {
    if (inputs[0] != "train")
      throw Usage_error("there is no 'roles " + inputs[0] +
                        "'; known is: train. `label` predicts roles, and `evaluate` scores matches");
    if (roles_.output.empty()) throw Usage_error("'roles train' needs --output MODEL");
    roles_.training.folders.assign(inputs.begin() + 1, inputs.end());
    roles_.training.options.seed = std::uint64_t(common.seed);
  }

  void work() override { train(roles_, common); }

  Roles_options roles_;
};

} // namespace

std::unique_ptr<Command> roles_command() { return std::make_unique<Roles_command>(); }

} // namespace CGAL::Shape_correspondence::cli

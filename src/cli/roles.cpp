// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/Command.h"
#include "cli/predicted_labels.h"
#include "cli/role_reports.h"
#include "cli/run.h"

#include <CGAL/Shape_correspondence/IO/role_model.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <algorithm>
#include <iostream>
#include <limits>

namespace CGAL::Shape_correspondence::cli {

using namespace internal;

namespace {

const char* const roles_help =
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
  std::string output, manifest, date, model, category, examples;
  Validation_options validation;
  std::string left_out = "shapes";
  std::size_t shown_examples = 0; // 0: all
  int pairs = 45;
  Role_training_options training;
};

void evaluate(const std::vector<std::string>& folders, const Roles_options& roles, const Common_options& common)
{
  const Role_training_set set(folders, roles.generated, std::size_t(roles.pairs), common);
  if (set.pairs.empty()) throw Invalid_input(folders[0] + ": it takes two shapes of a category to match any");
  const Role_validation validation(set.shapes, set.pairs, roles.validation, roles.training);
  write_output(common.json, [&](std::ostream& out) {
    role_evaluation_json(set, validation, roles.left_out, roles.training.seed).write(out);
  });
  if (common.prints_table()) write_role_table(std::cout, set, validation, roles.training.seed);
}

void train(const std::vector<std::string>& folders, const Roles_options& roles, const Common_options& common)
{
  if (roles.output.empty()) throw Usage_error("'roles train' needs --output MODEL");
  const Role_training_set set(folders, roles.generated, std::size_t(roles.pairs), common);
  const Role_validation validation(set.shapes, set.pairs, {}, roles.training);
  const Role_model model = validation.model();
  IO::write_role_model(roles.output, model);
  write_output(roles.manifest, [&](std::ostream& out) {
    role_manifest_json(set, validation, model, roles.date, roles.training).write(out);
  });
  if (common.prints_table() && roles.manifest != "-" && !set.pairs.empty())
    write_role_table(std::cout, set, validation, roles.training.seed);
}

class Roles_command : public Command
{
public:
  Roles_command() : Command(roles_help, 2, any_number)
  {
    Option_table::Group add = table.group("Options of roles");
    const std::vector<std::string> train{"train"}, evaluate{"evaluate"}, predict{"predict"};
    const std::vector<std::string> both{"train", "evaluate"};
    Validation_options& validation = roles_.validation;
    add("output,o", "MODEL", &roles_.output, "train: write the model to this file").output().only_for(train);
    add("manifest", "FILE", &roles_.manifest,
        "train: write the training shapes and the accuracy of the model as JSON; - is standard output")
        .output()
        .only_for(train);
    add("date", "DATE", &roles_.date, "train: date to put into the manifest").only_for(train);
    add("generated", "FOLDER", &roles_.generated,
        "train, evaluate: further labelled shapes that are generated; they have a third of the weight of real ones and "
        "are never left out. Can be repeated")
        .only_for(both);
    add("leave-out", "WHAT", &roles_.left_out,
        "evaluate: what is left out of the training for a pair of shapes: shapes (the two), sources (all shapes with "
        "their `source` in labels.json) or category (all shapes of their category)")
        .words({"shapes", "sources", "category"})
        .only_for(evaluate);
    add("examples", "FOLDER", &roles_.examples,
        "predict: labelled shapes that the model learns in addition, as of `match`")
        .input()
        .only_for(predict);
    add("number-of-examples", "N", &roles_.shown_examples,
        "evaluate: the training sees at most N shapes of the pair's category that are not generated, drawn for every "
        "pair; with --leave-out category, no others of the category. Default: all that are not left out")
        .at_least(1)
        .without_default()
        .only_for(evaluate);
    add("told", &validation.category_is_told, "evaluate: give the category to the matcher, as by --category")
        .only_for(evaluate);
    add("turned", "HOW",
        choice<Validation_turns>(
            validation.turns,
            {{"no", Validation_turns::NONE}, {"quarters", Validation_turns::QUARTERS}, {"any", Validation_turns::ANY}}),
        "evaluate: turn every shape about the up axis by an angle drawn for the pair: no, quarters (a multiple of 90°) "
        "or any")
        .only_for(evaluate);
    add("front", "HOW",
        choice<Validation_fronts>(validation.fronts, {{"given", Validation_fronts::GIVEN},
                                                      {"likely", Validation_fronts::LIKELY},
                                                      {"auto", Validation_fronts::AUTO}}),
        "evaluate: what the matcher does about fronts, as --front of `match`: given, likely or auto")
        .only_for(evaluate);
    add("role-weight", "W", &validation.role_weight,
        "evaluate: compare the correspondences of least energy, by exact search, without roles and with roles of this "
        "weight in the energy; 0: compare matching by parts")
        .between(0, std::numeric_limits<double>::max())
        .only_for(evaluate);
    add("pairs", "N", &roles_.pairs,
        "train, evaluate: match at most N pairs of a category and folder, unless the folder has a pairs.json: "
        "[[CATEGORY, SOURCE, TARGET], ...]")
        .at_least(1)
        .only_for(both);
    add("trees", "N", &roles_.training.trees, "train, evaluate: trees in the forest of a category")
        .at_least(1)
        .only_for(both);
    add("roles", "MODEL", &roles_.model, "predict: the role model; default: the one that comes with the program")
        .input()
        .only_for(predict);
    add("category", "NAME", &roles_.category,
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
    for (const char* option : {"turned", "front"})
      if (table.is_given(option) && roles_.validation.role_weight > 0) refuse_option(option, "with --role-weight");
    if (action_ == "train" && roles_.output.empty()) throw Usage_error("'roles train' needs --output MODEL");
    if (action_ == "predict" && inputs.size() != 1) throw Usage_error("'roles predict' takes one shape");
    if (roles_.shown_examples > 0) roles_.validation.examples = roles_.shown_examples;
    roles_.validation.left_out = roles_.left_out == "shapes"    ? Left_out::SHAPES
                                 : roles_.left_out == "sources" ? Left_out::SOURCES
                                                                : Left_out::CATEGORY;
    roles_.training.seed = std::uint64_t(common.seed);
  }

  void work() override
  {
    if (action_ == "train")
      train(inputs, roles_, common);
    else if (action_ == "evaluate")
      evaluate(inputs, roles_, common);
    else
      label_shape(inputs[0], {roles_.model, roles_.examples, roles_.category}, common.json, common);
  }

  Roles_options roles_;
  std::string action_;
};

} // namespace

std::unique_ptr<Command> roles_command() { return std::make_unique<Roles_command>(); }

} // namespace CGAL::Shape_correspondence::cli

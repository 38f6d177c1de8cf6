// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/outputs.h"
#include "cli/predicted_labels.h"
#include "cli/role_reports.h"
#include "cli/run_report.h"
#include "cli/thread_limit.h"

#include <CGAL/Shape_correspondence/IO/role_model.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <algorithm>
#include <cmath>
#include <iostream>

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
  std::string turned = "no", front = "given";
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
  add("turned", po::value(&roles.turned)->value_name("HOW")->default_value(roles.turned),
      "evaluate: turn every shape about the up axis by an angle drawn for the pair: no, quarters (a multiple of 90°) "
      "or any");
  add("front", po::value(&roles.front)->value_name("HOW")->default_value(roles.front),
      "evaluate: what the matcher does about fronts, as --front of `match`: given, likely or auto");
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
  check_word("turned", roles.turned, {"no", "quarters", "any"});
  check_word("front", roles.front, {"given", "likely", "auto"});
  result.turns = roles.turned == "any"        ? Validation_turns::ANY
                 : roles.turned == "quarters" ? Validation_turns::QUARTERS
                                              : Validation_turns::NONE;
  result.fronts = roles.front == "auto"     ? Validation_fronts::AUTO
                  : roles.front == "likely" ? Validation_fronts::LIKELY
                                            : Validation_fronts::GIVEN;
  return result;
}

void evaluate(const std::vector<std::string>& folders, const Roles_options& roles, const Common_options& common)
{
  check_outputs({common.json}, {});
  const Role_training_set set(folders, roles.generated, std::size_t(roles.pairs), common);
  if (set.pairs.empty()) throw Invalid_input(folders[0] + ": it takes two shapes of a category to match any");
  const Role_validation validation(set.shapes, set.pairs, validation_options(roles), roles.training);
  write_output(common.json, [&](std::ostream& out) {
    role_evaluation_json(set, validation, roles.leave_out, roles.training.seed).write(out);
  });
  if (common.prints_table()) write_role_table(std::cout, set, validation, roles.training.seed);
}

void train(const std::vector<std::string>& folders, const Roles_options& roles, const Common_options& common)
{
  if (roles.output.empty()) throw Usage_error("'roles train' needs --output MODEL");
  check_outputs({roles.output, roles.manifest}, {});
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
                                                                         {"front", {"evaluate"}},
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
  for (const char* option : {"turned", "front"})
    if (is_given(parsed.values, option) && roles.role_weight > 0)
      throw Usage_error("--" + std::string(option) + " has no effect with --role-weight");
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

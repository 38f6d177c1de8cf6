// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/for_each_index.h"
#include "cli/Command.h"
#include "cli/collection.h"
#include "cli/jobs.h"
#include "cli/load_shape.h"
#include "cli/run.h"
#include "io/system/atomic_file.h"
#include "io/system/quoting.h"
#include "io/write/Json.h"
#include "roles/Role_model_data.h"

#include <CGAL/Shape_correspondence/IO/role_model.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <set>
#include <vector>

namespace CGAL::Shape_correspondence::cli {
using namespace internal;
namespace fs = std::filesystem;

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
  std::int64_t seed = 0;
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
        "of a category at most. Can be repeated");
    add("trees", "N", &roles_.training.options.trees, "trees in the forest of a category").at_least(1);
    add("seed", "N", &roles_.seed, "seed of the random choices; the same seed gives the same model");
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
    roles_.training.options.seed = std::uint64_t(roles_.seed);
  }

  void work() override { train(roles_, common); }

  Roles_options roles_;
};

const char* const label_help =
    R"(Usage: shape_correspondence label SHAPE [--output labels.json] [options]

Labels the parts of a shape: predicts the role of each, such as leg or seat, by a role model, and prints it with its
probability. SHAPE is a model file or a folder of part meshes, as in `graph`; it must be upright and face +z. The labels
are in the form that `roles train`, `evaluate` and `collection --labels-from` read.

Examples: shape_correspondence label chair.obj --output labels.json
          shape_correspondence label stool.glb --category chair

)";

// The most probable label of every part, with the probability of its role.
std::vector<Transferred_label> likeliest_labels(const Part_roles& found)
{
  std::vector<Transferred_label> result;
  for (std::size_t part = 0; part < found.labels.size(); ++part)
    result.push_back({found.labels[part], found.probabilities.row(Eigen::Index(part)).maxCoeff()});
  return result;
}

/// The labels of parts with their probabilities, as in `labels.json`; unlabelled parts are left out.
IO::Json parts_json(const std::vector<std::string>& parts, const std::vector<Transferred_label>& labels)
{
  IO::Json result = IO::Json::array();
  for (std::size_t part = 0; part < parts.size(); ++part) {
    const auto& [label, probability] = labels[part];
    if (label.coarse.empty()) continue;
    IO::Json entry = {{"name", parts[part]}, {"coarse", label.coarse}};
    if (!label.fine.empty()) entry["fine"] = label.fine;
    entry["probability"] = probability;
    result.push_back(std::move(entry));
  }
  return result;
}

IO::Json labels_json(const std::vector<std::string>& parts, const std::string& category,
                     const std::vector<Transferred_label>& labels)
{
  return {{"format", "shape_correspondence/labels"}, {"category", category}, {"parts", parts_json(parts, labels)}};
}

using Labels = std::vector<Transferred_label>; // indexed by part

Labelled_model labelled_source(const std::string& path, const Common_options& common)
{
  std::vector<Labelled_model> models = load_labelled_models({path}, common);
  if (models.size() > 1)
    throw Invalid_input(path + ": it has " + std::to_string(models.size()) +
                        " labelled shapes; give --labels-from the folder of one");
  return std::move(models[0]);
}

/// The folder for a shape's labels, named after the shape's file or folder.
fs::path folder_of(const Collection_shape& shape, const std::string& folder)
{
  const fs::path path = fs::absolute(shape.path).lexically_normal();
  const fs::path name = path.has_filename() ? path : path.parent_path();
  return fs::path(folder) / (fs::is_directory(name) ? name.filename() : name.stem());
}

void write_files(const Collection_shapes& shapes, const std::string& category, const std::vector<Labels>& labels,
                 const std::string& folder)
{
  std::set<fs::path> used;
  for (const Collection_shape& shape : shapes.shapes())
    if (!used.insert(folder_of(shape, folder)).second)
      throw Invalid_input(shape.path +
                          ": another shape of the set has the same name, so that its labels would go to '" +
                          folder_of(shape, folder).string() + "', too; rename one");
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const fs::path target = folder_of(shapes.shapes()[i], folder);
    fs::create_directories(target);
    IO::write_atomically((target / "labels.json").string(), [&](std::ostream& out) {
      labels_json(shapes.shapes()[i].parts, category, labels[i]).write(out);
    });
  }
}

IO::Json document(const Labelled_model& source, const Collection_shapes& shapes, const std::vector<Labels>& labels)
{
  IO::Json of_shapes = IO::Json::array();
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const Collection_shape& shape = shapes.shapes()[i];
    of_shapes.push_back({{"name", shape.name}, {"file", shape.path}, {"parts", parts_json(shape.parts, labels[i])}});
  }
  return {{"format", "shape_correspondence/transferred_labels"},
          {"version", 1},
          {"source", source.labels.file},
          {"category", source.labels.category},
          {"shapes", of_shapes},
          {"warnings", shapes.skipped()}};
}

void print(const Collection_shapes& shapes, const std::vector<Labels>& labels)
{
  std::vector<std::vector<std::string>> rows{{"shape", "parts", "mean confidence", "labels"}};
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    double sum = 0;
    std::map<std::string, int> counts;
    for (const Transferred_label& label : labels[i]) {
      sum += label.confidence;
      ++counts[label.label.coarse];
    }
    std::string text;
    for (const auto& [label, count] : counts)
      text += (text.empty() ? "" : ", ") + std::to_string(count) + ' ' + label;
    const std::size_t parts = std::max<std::size_t>(1, labels[i].size());
    rows.push_back(
        {shapes.shapes()[i].name, std::to_string(labels[i].size()), short_number(sum / double(parts)), text});
  }
  write_table(std::cout, rows);
}

class Label_command : public Command
{
public:
  Label_command() : Command(label_help, 1, 1)
  {
    Option_table::Group add = table.group("Options of label");
    add("output,o", "FILE", &output_, "write the labels as JSON; - is standard output").output();
    add("roles", "MODEL", &roles_,
        "role model, which `roles train` wrote; default: the one that comes with the program")
        .input();
    add("examples", "FOLDER", &examples_, "labelled shapes of your own that are learned in addition, as of `match`")
        .input();
    add("category", "NAME", &category_,
        "category of the shape, such as chair; default: the one whose labelled parts are most similar to its parts");
    add_model_options(table, common);
    add_common_options(table, common);
  }

private:
  void work() override
  {
    std::shared_ptr<const Role_model> model = role_model_of(roles_);
    Common_options with_roles = common;
    with_roles.roles = model;
    const Loaded_shape shape = std::move(load_shapes(inputs, with_roles)[0]);
    std::string category = category_;
    for (const std::string& left_out : add_examples(examples_, common, model, category, true))
      warn(common, left_out);
    const Part_roles found = predicted_roles(inputs[0], shape.graph, *model, category);
    write_output(output_, [&](std::ostream& out) { write_labels_json(out, shape.graph, found); });
    if (!common.prints_table() || output_ == "-") return;
    const std::vector<Transferred_label> labels = likeliest_labels(found);
    const std::vector<std::string> parts = part_names(shape.graph);
    std::vector<std::vector<std::string>> rows{{"part", "role", "fine label", "probability"}};
    for (std::size_t part = 0; part < parts.size(); ++part)
      rows.push_back(
          {parts[part], labels[part].label.coarse, labels[part].label.fine, percentage(labels[part].confidence)});
    std::cout << IO::quote_terminal(inputs[0] + ": " + found.category) << "\n\n";
    write_table(std::cout, rows);
  }

  std::string output_, roles_, examples_, category_;
};

} // namespace

std::unique_ptr<Command> roles_command() { return std::make_unique<Roles_command>(); }

Part_roles predicted_roles(const std::string& path, const Structural_graph& graph, const Role_model& model,
                           const std::string& category)
{
  Part_roles found = part_roles(graph, model, category);
  if (found.category.empty())
    throw Invalid_input(path +
                        ": the shape is not clearly of a category that the role model knows; name one with --category");
  return found;
}

void write_labels_json(std::ostream& out, const Structural_graph& graph, const Part_roles& found)
{
  labels_json(part_names(graph), found.category, likeliest_labels(found)).write(out);
}

void transfer_labels(const Collection_shapes& shapes, const Collection_options& options, const Search_options& search,
                     const Common_options& common)
{
  const Labelled_model source = labelled_source(options.labels_from, common);
  const Correspondence_finder finder(source.graph, search);
  std::vector<Labels> labels(shapes.size());
  internal::for_each_index(shapes.size(), true, [&](std::size_t i) {
    const Structural_graph target = shapes.graph(i);
    labels[i] = finder.transfer_labels(source.part_labels, Prepared_shape(target));
  });
  if (!options.labels_to.empty()) write_files(shapes, source.labels.category, labels, options.labels_to);
  write_output(common.json, [&](std::ostream& out) { document(source, shapes, labels).write(out); });
  if (common.prints_table()) print(shapes, labels);
}

std::unique_ptr<Command> label_command() { return std::make_unique<Label_command>(); }

} // namespace CGAL::Shape_correspondence::cli

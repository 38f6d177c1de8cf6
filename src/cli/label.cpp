// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/Command.h"
#include "cli/labels.h"
#include "cli/load_shape.h"
#include "cli/run.h"
#include "cli/text.h"
#include "io/system/quoting.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <iostream>
#include <memory>
#include <vector>

namespace CGAL::Shape_correspondence::cli {

namespace {

const char* const label_help =
    R"(Usage: shape_correspondence label SHAPE [--output labels.json] [options]

Labels the parts of a shape: predicts the role of each, such as leg or seat, by a role model, and prints it with its
probability. SHAPE is a model file or a folder of part meshes, as in `graph`; it must be upright and face +z. The labels
are in the form that `roles train`, `evaluate` and `collection --labels-from` read.

Examples: shape_correspondence label chair.obj --output labels.json
          shape_correspondence label stool.glb --category chair

)";

// The likeliest label of every part, with the probability of its role.
std::vector<Transferred_label> likeliest_labels(const Part_roles& found)
{
  std::vector<Transferred_label> result;
  for (std::size_t part = 0; part < found.labels.size(); ++part)
    result.push_back({found.labels[part], found.probabilities.row(Eigen::Index(part)).maxCoeff()});
  return result;
}

} // namespace

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

void label_shape(const std::string& path, const Label_options& options, const std::string& output,
                 const Common_options& common)
{
  std::shared_ptr<const Role_model> model = role_model_of(options.roles);
  Common_options with_roles = common;
  with_roles.roles = model;
  const Loaded_shape shape = std::move(load_shapes({path}, with_roles)[0]);
  std::string category = options.category;
  for (const std::string& left_out : add_examples(options.examples, common, model, category, true))
    warn(common, left_out);
  const Part_roles found = predicted_roles(path, shape.graph, *model, category);
  const std::vector<Transferred_label> labels = likeliest_labels(found);
  const std::vector<std::string> parts = part_names(shape.graph);
  write_output(output, [&](std::ostream& out) { write_labels_json(out, shape.graph, found); });
  if (!common.prints_table() || output == "-") return;
  std::vector<std::vector<std::string>> rows{{"part", "role", "fine label", "probability"}};
  for (std::size_t part = 0; part < parts.size(); ++part)
    rows.push_back(
        {parts[part], labels[part].label.coarse, labels[part].label.fine, percentage(labels[part].confidence)});
  std::cout << IO::quote_terminal(path + ": " + found.category) << "\n\n";
  write_table(std::cout, rows);
}

namespace {

class Label_command : public Command
{
public:
  Label_command() : Command(label_help, 1, 1)
  {
    Option_table::Group add = table.group("Options of label");
    add("output,o", "FILE", &output_, "write the labels as JSON; - is standard output").output();
    add("roles", "MODEL", &label_.roles,
        "role model, which `roles train` wrote; default: the one that comes with the program")
        .input();
    add("examples", "FOLDER", &label_.examples,
        "labelled shapes of your own that are learned in addition, as of `match`")
        .input();
    add("category", "NAME", &label_.category,
        "category of the shape, such as chair; default: the one whose labelled parts are most similar to its parts");
    add_model_options(table, common);
    add_common_options(table, common);
  }

private:
  void work() override { label_shape(inputs[0], label_, output_, common); }

  Label_options label_;
  std::string output_;
};

} // namespace

std::unique_ptr<Command> label_command() { return std::make_unique<Label_command>(); }

} // namespace CGAL::Shape_correspondence::cli

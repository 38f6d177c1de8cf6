// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "roles/Role_trainer.h"
#include "base/for_each_index.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace CGAL::Shape_correspondence::internal {

namespace {

// Whole number that stands for a shape's weight of 1. Weights are whole numbers, so that sums do not depend on the
// order of the parts.
constexpr double weight_steps = 1e6;

void check(const std::vector<Labelled_graph>& shapes, const Role_training_options& options)
{
  if (options.trees < 1 || options.trees > maximum_trees)
    throw Invalid_input("train_role_model: the number of trees must be between 1 and " + std::to_string(maximum_trees));
  if (options.generated_per_tree < 0)
    throw Invalid_input("train_role_model: the number of generated shapes of a tree must be 0 or more");
  for (const Labelled_graph& shape : shapes) {
    if (!shape.graph) throw Invalid_input("train_role_model: a labelled shape has no graph; build one");
    const std::string name = "train_role_model: the shape '" + structure(*shape.graph).name + "' ";
    if (shape.category.empty()) throw Invalid_input(name + "has no category; give it one");
    if (shape.labels.size() != structure(*shape.graph).parts.size())
      throw Invalid_input(name + "needs a role for every part");
    for (const Part_label& label : shape.labels)
      if (label.coarse.empty()) throw Invalid_input(name + "has a part without a role; give it one");
    if (!(shape.weight > 0) || !std::isfinite(shape.weight)) throw Invalid_input(name + "must have a weight above 0");
  }
}

// Removes the word for a side from a fine label. \return whether it had one
bool take_out_side(std::string& fine)
{
  for (const std::string side : {"_left", "_right"})
    for (std::size_t at = fine.find(side); at != std::string::npos; at = fine.find(side, at + 1)) {
      const std::size_t end = at + side.size();
      if (end < fine.size() && fine[end] != '_') continue;
      fine.erase(at, side.size());
      return true;
    }
  return false;
}

// A label without its side, and whether it named one.
struct Example_label
{
  std::string role, fine;
  bool has_side = false;
};

// The labels of a shape's parts. Fine labels are used for roles of which all parts have one.
std::vector<Example_label> example_labels(const std::vector<Part_label>& labels)
{
  std::set<std::string> without_fine;
  for (const Part_label& label : labels)
    if (label.fine.empty()) without_fine.insert(label.coarse);
  std::vector<Example_label> result;
  for (const Part_label& label : labels) {
    Example_label example{label.coarse, without_fine.count(label.coarse) > 0 ? "" : label.fine};
    example.has_side = take_out_side(example.fine);
    result.push_back(std::move(example));
  }
  return result;
}

// Sets the roles and classes of labelled parts. A class has sides if most of its parts name one.
void set_classes(const std::vector<Example_label>& labels, Category_roles& category)
{
  std::map<std::pair<std::string, std::string>, long> sides; // number of parts with a side minus those without
  std::set<std::string> roles;
  for (const Example_label& label : labels) {
    sides[{label.role, label.fine}] += label.has_side ? 1 : -1;
    roles.insert(label.role);
  }
  category.roles.assign(roles.begin(), roles.end());
  if (sides.size() > maximum_classes)
    throw Invalid_input("train_role_model: the category '" + category.name + "' has more than " +
                        std::to_string(maximum_classes) + " labels; use fewer");
  for (const auto& [label, side] : sides)
    category.classes.push_back(
        {std::uint8_t(std::distance(roles.begin(), roles.find(label.first))), label.second, side > 0});
}

std::uint8_t class_of(const Example_label& label, const Category_roles& category)
{
  const auto role = std::lower_bound(category.roles.begin(), category.roles.end(), label.role);
  const Role_class key{std::uint8_t(role - category.roles.begin()), label.fine, false};
  return std::uint8_t(std::lower_bound(category.classes.begin(), category.classes.end(), key) -
                      category.classes.begin());
}

// A labelled part before the classes are numbered.
struct Labelled_part
{
  Example_label label;
  Role_example example;
};

std::vector<Labelled_part> labelled_parts(const Labelled_graph& shape, const Role_features& features)
{
  std::vector<Labelled_part> result;
  const double weight = std::max(1., std::round(weight_steps * shape.weight / double(shape.labels.size())));
  for (Example_label& label : example_labels(shape.labels)) {
    Labelled_part part{std::move(label), {}};
    std::copy_n(&features(Eigen::Index(result.size()), 0), ROLE_FEATURE_COUNT, part.example.features.begin());
    part.example.weight = weight;
    result.push_back(std::move(part));
  }
  return result;
}

std::vector<Example_label> labels_of(const std::vector<Labelled_part>& parts)
{
  std::vector<Example_label> result;
  for (const Labelled_part& part : parts)
    result.push_back(part.label);
  return result;
}

std::vector<Role_example> examples_of(const std::vector<Labelled_part>& parts, const Category_roles& category)
{
  std::vector<Role_example> result;
  for (const auto& [label, example] : parts) {
    result.push_back(example);
    result.back().role = class_of(label, category);
  }
  std::sort(result.begin(), result.end());
  return result;
}

std::vector<Labelled_part> known_parts(const Category_roles& category)
{
  std::vector<Labelled_part> result;
  for (const Role_example& example : category.examples) {
    const Role_class& known = category.classes[example.role];
    result.push_back({{category.roles[known.role], known.fine, known.has_side}, example});
  }
  return result;
}

} // namespace

Role_trainer::Role_trainer(const std::vector<Labelled_graph>& shapes, const Role_training_options& options,
                           const Role_model_data& known)
    : shapes_(shapes), options_(options), known_(known), evidence_(shapes.size())
{
  check(shapes, options);
  for_each_index(shapes.size(), true,
                 [&](std::size_t shape) { evidence_[shape] = role_evidence(*shapes[shape].graph); });
}

Category_roles Role_trainer::category(const std::string& name, const std::vector<char>& is_left_out) const
{
  Category_roles result;
  std::vector<Labelled_part> parts;
  const std::size_t known = known_.index(name);
  if (known < known_.categories.size()) {
    static_cast<Match_weights&>(result) = known_.categories[known];
    parts = known_parts(known_.categories[known]);
  }
  result.name = name;
  std::vector<std::vector<Labelled_part>> generated;
  std::size_t count = 0;
  for (std::size_t shape = 0; shape < shapes_.size(); ++shape) {
    if (shapes_[shape].category != name || is_left_out[shape]) continue;
    ++count;
    std::vector<Labelled_part> of_shape = labelled_parts(shapes_[shape], evidence_[shape].features);
    if (shapes_[shape].is_generated)
      generated.push_back(std::move(of_shape));
    else
      parts.insert(parts.end(), of_shape.begin(), of_shape.end());
  }
  if (parts.empty() && generated.empty()) return result;
  if (known == known_.categories.size()) {
    result.weights = usual_pair_weights(count);
    result.geometric_confidence = known_.geometric_confidence;
  }
  std::vector<Example_label> labels = labels_of(parts);
  for (const std::vector<Labelled_part>& of_shape : generated)
    for (Example_label& label : labels_of(of_shape))
      labels.push_back(std::move(label));
  set_classes(labels, result);
  result.examples = examples_of(parts, result);
  std::vector<std::vector<Role_example>> drawn;
  for (const std::vector<Labelled_part>& of_shape : generated)
    drawn.push_back(examples_of(of_shape, result));
  std::sort(drawn.begin(), drawn.end());
  result.forest =
      Role_forest(result.examples, options_.trees, options_.seed, drawn, std::size_t(options_.generated_per_tree));
  if (parts.empty()) // there are only generated shapes to measure distances from
    for (const std::vector<Role_example>& examples : drawn)
      result.examples.insert(result.examples.end(), examples.begin(), examples.end());
  std::sort(result.examples.begin(), result.examples.end());
  return result;
}

Role_model_data Role_trainer::model() const
{
  std::set<std::string> taught;
  for (const Labelled_graph& shape : shapes_)
    taught.insert(shape.category);
  const std::vector<std::string> names(taught.begin(), taught.end());
  std::vector<Category_roles> categories(names.size());
  for_each_index(names.size(), true,
                 [&](std::size_t i) { categories[i] = category(names[i], std::vector<char>(shapes_.size(), 0)); });
  Role_model_data result;
  result.trees = options_.trees;
  result.geometric_confidence = known_.geometric_confidence;
  result.parts = known_.parts;
  for (const Category_roles& known : known_.categories)
    if (taught.count(known.name) == 0) categories.push_back(known);
  std::sort(categories.begin(), categories.end(),
            [](const Category_roles& a, const Category_roles& b) { return a.name < b.name; });
  result.categories = std::move(categories);
  return result;
}

} // namespace CGAL::Shape_correspondence::internal

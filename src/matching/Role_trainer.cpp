// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "matching/Role_trainer.h"
#include "base/for_each_index.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace CGAL::Shape_correspondence {

namespace internal {

namespace {

// Of a shape that weighs 1, in whole steps, so that sums do not depend on the order of the parts.
constexpr double weight_steps = 1e6;

void check(const std::vector<Labelled_graph>& shapes, const Role_training_options& options)
{
  if (options.trees < 1 || options.trees > maximum_trees)
    throw Invalid_input("train_role_model: the number of trees must be between 1 and " + std::to_string(maximum_trees));
  for (const Labelled_graph& shape : shapes) {
    const std::string name = "train_role_model: the shape '" + structure(*shape.graph).name + "' ";
    if (shape.category.empty()) throw Invalid_input(name + "has no category");
    if (shape.labels.size() != structure(*shape.graph).parts.size())
      throw Invalid_input(name + "needs a role for every part");
    for (const Part_label& label : shape.labels)
      if (label.coarse.empty()) throw Invalid_input(name + "has a part without a role");
    if (!(shape.weight > 0) || !std::isfinite(shape.weight)) throw Invalid_input(name + "must have a weight above 0");
  }
}

// Takes the word for a side out of a fine label; false if it has none.
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

// A label, and whether it names a side.
struct Example_label
{
  std::string role, fine;
  bool has_side = false;
};

// Fine labels count where all parts of a role have one.
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

// The roles and classes of labelled parts. A class has a side where most of its parts have.
void set_classes(const std::vector<Example_label>& labels, Category_roles& category)
{
  std::map<std::pair<std::string, std::string>, long> sides; // those with, less those without
  std::set<std::string> roles;
  for (const Example_label& label : labels) {
    sides[{label.role, label.fine}] += label.has_side ? 1 : -1;
    roles.insert(label.role);
  }
  category.roles.assign(roles.begin(), roles.end());
  if (sides.size() > maximum_classes)
    throw Invalid_input("train_role_model: the category '" + category.name + "' has more than " +
                        std::to_string(maximum_classes) + " labels");
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

} // namespace

Role_trainer::Role_trainer(const std::vector<Labelled_graph>& shapes, const Role_training_options& options)
    : shapes_(shapes), options_(options), evidence_(shapes.size())
{
  check(shapes, options);
  for_each_index(shapes.size(), true,
                 [&](std::size_t shape) { evidence_[shape] = role_evidence(*shapes[shape].graph); });
}

std::vector<std::string> Role_trainer::categories() const
{
  std::set<std::string> names;
  for (const Labelled_graph& shape : shapes_)
    names.insert(shape.category);
  return {names.begin(), names.end()};
}

Category_roles Role_trainer::category(const std::string& name, const std::vector<char>& is_left_out) const
{
  Category_roles result;
  result.name = name;
  std::vector<std::size_t> chosen;
  std::vector<Example_label> labels;
  for (std::size_t shape = 0; shape < shapes_.size(); ++shape)
    if (shapes_[shape].category == name && !is_left_out[shape]) {
      chosen.push_back(shape);
      for (Example_label& label : example_labels(shapes_[shape].labels))
        labels.push_back(std::move(label));
    }
  set_classes(labels, result);

  std::vector<Role_example> examples;
  for (std::size_t shape : chosen) {
    const std::size_t size = shapes_[shape].labels.size();
    const double weight = std::round(weight_steps * shapes_[shape].weight / double(size));
    for (std::size_t part = 0; part < size; ++part) {
      Role_example example;
      std::copy_n(&evidence_[shape].features(Eigen::Index(part), 0), ROLE_FEATURE_COUNT, example.features.begin());
      example.role = class_of(labels[examples.size()], result);
      example.weight = std::max(1., weight);
      examples.push_back(example);
    }
  }
  if (examples.empty()) return result;
  std::sort(examples.begin(), examples.end());
  result.examples.resize(Eigen::Index(examples.size()), ROLE_FEATURE_COUNT);
  for (std::size_t i = 0; i < examples.size(); ++i)
    std::copy(examples[i].features.begin(), examples[i].features.end(), &result.examples(Eigen::Index(i), 0));
  result.forest = Role_forest(examples, options_.trees, options_.seed);
  return result;
}

Role_model_data Role_trainer::model() const
{
  const std::vector<std::string> names = categories();
  Role_model_data result;
  result.trees = options_.trees;
  result.categories.resize(names.size());
  for_each_index(names.size(), true, [&](std::size_t i) {
    result.categories[i] = category(names[i], std::vector<char>(shapes_.size(), 0));
  });
  return result;
}

} // namespace internal

Role_model train_role_model(const std::vector<Labelled_graph>& shapes, const Role_training_options& options)
{
  return Role_model(internal::Role_trainer(shapes, options).model());
}

} // namespace CGAL::Shape_correspondence

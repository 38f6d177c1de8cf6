// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "matching/Role_trainer.h"
#include "base/for_each_index.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace CGAL::Shape_correspondence {

namespace internal {

namespace {

// Of a shape that weighs 1, in whole steps, so that sums do not depend on the order of the parts.
constexpr double weight_steps = 1e6;

void check(const std::vector<Labelled_graph>& shapes, const Role_training_options& options)
{
  if (options.trees < 1 || options.trees > 1000)
    throw Invalid_input("train_role_model: the number of trees must be between 1 and 1000");
  for (const Labelled_graph& shape : shapes) {
    const std::string name = "train_role_model: the shape '" + structure(*shape.graph).name + "' ";
    if (shape.category.empty()) throw Invalid_input(name + "has no category");
    if (shape.roles.size() != structure(*shape.graph).parts.size())
      throw Invalid_input(name + "needs a role for every part");
    if (std::count(shape.roles.begin(), shape.roles.end(), "") > 0)
      throw Invalid_input(name + "has a part without a role");
    if (!(shape.weight > 0) || !std::isfinite(shape.weight)) throw Invalid_input(name + "must have a weight above 0");
  }
}

} // namespace

Role_trainer::Role_trainer(const std::vector<Labelled_graph>& shapes, const Role_training_options& options)
    : shapes_(shapes), options_(options), features_(shapes.size())
{
  check(shapes, options);
  for_each_index(shapes.size(), true,
                 [&](std::size_t shape) { features_[shape] = given_role_features(*shapes[shape].graph); });
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
  std::vector<std::size_t> chosen;
  std::set<std::string> roles;
  for (std::size_t shape = 0; shape < shapes_.size(); ++shape)
    if (shapes_[shape].category == name && !is_left_out[shape]) {
      chosen.push_back(shape);
      roles.insert(shapes_[shape].roles.begin(), shapes_[shape].roles.end());
    }
  Category_roles result;
  result.name = name;
  result.roles.assign(roles.begin(), roles.end());
  if (result.roles.size() > maximum_roles)
    throw Invalid_input("train_role_model: the category '" + name + "' has more than 255 roles");

  std::vector<Role_example> examples;
  for (std::size_t shape : chosen) {
    const Labelled_graph& labelled = shapes_[shape];
    const double weight = std::round(weight_steps * labelled.weight / double(labelled.roles.size()));
    for (std::size_t part = 0; part < labelled.roles.size(); ++part) {
      Role_example example;
      std::copy_n(&features_[shape](Eigen::Index(part), 0), ROLE_FEATURE_COUNT, example.features.begin());
      example.role = std::uint8_t(std::distance(roles.begin(), roles.find(labelled.roles[part])));
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

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "matching/Shape_roles.h"

#include <algorithm>
#include <string>
#include <utility>

namespace CGAL::Shape_correspondence::internal {

namespace {

// Set by cross-validation on labelled shapes, where they are flat; shares of the trees' votes.
constexpr double least_agreement = 0.45;   // cosine of the votes for two parts that the geometric match pairs
constexpr double least_certain = 0.35;     // product of the probabilities of a role that two parts are matched by
constexpr double least_touched = 0.75;     // share of the parts of a role that have a pair in the geometric match
constexpr double least_familiarity = 0.29; // of shapes with a category, see `familiarity()`

// The role that most trees vote for; the first of equals.
int likeliest_role(const Eigen::MatrixXi& votes, std::size_t part)
{
  Eigen::Index role = 0;
  votes.row(Eigen::Index(part)).maxCoeff(&role);
  return int(role);
}

std::vector<int> likeliest_roles(const Eigen::MatrixXi& votes, const std::vector<std::size_t>& parts)
{
  std::vector<int> result;
  for (std::size_t part : parts)
    result.push_back(likeliest_role(votes, part));
  return result;
}

std::vector<std::size_t> parts_of_role(const std::vector<int>& roles, int role)
{
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < roles.size(); ++i)
    if (roles[i] == role) result.push_back(i);
  return result;
}

double mean_top(const Eigen::MatrixXi& votes, int trees)
{
  return double(votes.rowwise().maxCoeff().sum()) / (double(votes.rows()) * trees);
}

using Pair_matrix = Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic>;

// Is the match one of the parts of a role in either shape that leaves few of them out?
bool is_refined(const Pair_matrix& pairs, const std::vector<std::size_t>& source,
                const std::vector<std::size_t>& target)
{
  if (source.size() != target.size()) return false;
  std::size_t touched = 0;
  for (std::size_t i : source)
    touched += std::any_of(target.begin(), target.end(),
                           [&](std::size_t j) { return pairs(Eigen::Index(i), Eigen::Index(j)); });
  for (std::size_t j : target)
    touched += std::any_of(source.begin(), source.end(),
                           [&](std::size_t i) { return pairs(Eigen::Index(i), Eigen::Index(j)); });
  return double(touched) >= least_touched * double(source.size() + target.size());
}

} // namespace

Shape_roles::Shape_roles(const Structural_graph& graph, const Role_model& model)
    : Shape_roles(given_role_features(graph), model)
{}

Shape_roles::Shape_roles(Role_features features, const Role_model& model)
    : model_(model), features_(std::move(features)), votes_(std::make_unique<Votes[]>(model.data().categories.size()))
{
  for (std::size_t category = 0; category < model.data().categories.size(); ++category)
    distances_.push_back(model.distances().mean_distance(features_, category));
}

const Eigen::MatrixXi& Shape_roles::votes(std::size_t category) const
{
  const Category_roles& roles = model_.data().categories[category];
  std::call_once(votes_[category].is_counted,
                 [&] { votes_[category].votes = roles.forest.votes(features_, int(roles.roles.size())); });
  return votes_[category].votes;
}

std::size_t nearest_category(const Shape_roles& source, const Shape_roles& target, const Role_model_data& model)
{
  const auto distance = [&](std::size_t category) { return source.distance(category) + target.distance(category); };
  std::size_t nearest = 0;
  for (std::size_t category = 1; category < model.categories.size(); ++category)
    if (distance(category) < distance(nearest)) nearest = category;
  return nearest;
}

double familiarity(const Shape_roles& source, const Shape_roles& target, std::size_t category, int trees)
{
  const auto of_shape = [&](const Shape_roles& shape) {
    return mean_top(shape.votes(category), trees) - shape.distance(category);
  };
  return (of_shape(source) + of_shape(target)) / 2;
}

Pair_category category_of_pair(const Shape_roles& source, const Shape_roles& target, const Role_model_data& model)
{
  const std::size_t none = model.categories.size(), nearest = nearest_category(source, target, model);
  if (nearest == none) return {none, "The role model knows no category; the parts were matched by geometry alone."};
  if (familiarity(source, target, nearest, model.trees) >= least_familiarity) return {nearest, ""};
  return {none, "The shapes are of no category that the role model knows (the nearest is " +
                    model.categories[nearest].name + "); the parts were matched by geometry alone."};
}

std::vector<std::string> likeliest_roles(const Eigen::MatrixXi& votes, const Category_roles& category)
{
  std::vector<std::string> result;
  for (Eigen::Index part = 0; part < votes.rows(); ++part)
    result.push_back(category.roles[std::size_t(likeliest_role(votes, std::size_t(part)))]);
  return result;
}

void join_roles(const Eigen::MatrixXi& source, const std::vector<std::size_t>& source_parts,
                const Eigen::MatrixXi& target, const std::vector<std::size_t>& target_parts,
                const Role_model_data& model, Role_trust trust, Part_matching& matching)
{
  if (trust == Role_trust::NONE) return;
  const double all = double(model.trees) * model.trees;
  const auto same = [&](std::size_t i, std::size_t j) {
    return source.row(Eigen::Index(source_parts[i])).dot(target.row(Eigen::Index(target_parts[j]))) / all;
  };
  const auto agree = [&](std::size_t i, std::size_t j) {
    const auto a = source.row(Eigen::Index(source_parts[i])), b = target.row(Eigen::Index(target_parts[j]));
    const double product = a.dot(b);
    return product * product > least_agreement * least_agreement * (double(a.squaredNorm()) * b.squaredNorm());
  };
  Pair_matrix geometric =
      Pair_matrix::Constant(Eigen::Index(source_parts.size()), Eigen::Index(target_parts.size()), false);
  for (const Part_correspondence& pair : matching.pairs)
    geometric(Eigen::Index(pair.source), Eigen::Index(pair.target)) = true;

  Pair_matrix joined = geometric;
  for (const Part_correspondence& pair : matching.pairs)
    joined(Eigen::Index(pair.source), Eigen::Index(pair.target)) = agree(pair.source, pair.target);
  if (trust == Role_trust::FULL) {
    const std::vector<int> source_roles = likeliest_roles(source, source_parts),
                           target_roles = likeliest_roles(target, target_parts);
    for (int role = 0; role < source.cols(); ++role) {
      const std::vector<std::size_t> a = parts_of_role(source_roles, role), b = parts_of_role(target_roles, role);
      const bool refined = is_refined(geometric, a, b);
      for (std::size_t i : a)
        for (std::size_t j : b) {
          const double certain =
              double(source(Eigen::Index(source_parts[i]), role)) * target(Eigen::Index(target_parts[j]), role) / all;
          if ((!refined || geometric(Eigen::Index(i), Eigen::Index(j))) && certain > least_certain)
            joined(Eigen::Index(i), Eigen::Index(j)) = true;
        }
    }
  }
  matching.pairs.clear();
  for (Eigen::Index i = 0; i < joined.rows(); ++i)
    for (Eigen::Index j = 0; j < joined.cols(); ++j)
      if (joined(i, j))
        matching.pairs.push_back(
            {std::size_t(i), std::size_t(j), confidence(model.confidences, same(std::size_t(i), std::size_t(j)))});
}

} // namespace CGAL::Shape_correspondence::internal

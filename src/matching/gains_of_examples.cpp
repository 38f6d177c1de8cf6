// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/for_each_index.h"

#include <CGAL/Shape_correspondence/evaluate_correspondence.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>
#include <CGAL/Shape_correspondence/ground_truth.h>
#include <CGAL/Shape_correspondence/train_role_model.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

namespace CGAL::Shape_correspondence {

namespace {

using Shape_pair = std::array<std::size_t, 2>;

constexpr std::size_t most_pairs = 20;  // of a category that are matched: twice as many take twice as long
constexpr std::size_t least_shapes = 3; // of a category: two are in the pair, and one is learned from
// Of a pair, which falls with the root of their number. Set by `validate_roles --own-examples`: less lets single
// categories lose, more refuses examples that help.
constexpr double chance_gain = 0.05;

// Spread evenly over all pairs.
std::vector<Shape_pair> spread_pairs(const std::vector<std::size_t>& shapes)
{
  std::vector<Shape_pair> all, result;
  if (shapes.size() < least_shapes) return result;
  for (std::size_t i = 0; i < shapes.size(); ++i)
    for (std::size_t j = i + 1; j < shapes.size(); ++j)
      all.push_back({shapes[i], shapes[j]});
  const std::size_t count = std::min(most_pairs, all.size());
  for (std::size_t k = 0; k < count; ++k)
    result.push_back(all[k * all.size() / count]);
  return result;
}

double f1(const Labelled_graph& source, const Labelled_graph& target, const Role_model& model,
          const std::string& category)
{
  Search_options search;
  search.roles = std::make_shared<const Role_model>(model);
  search.category = category;
  const Correspondence found = find_correspondence(*source.graph, *target.graph, search);
  return evaluate_correspondence(part_pairs(found.pairs), ground_truth(source.labels, target.labels)).f1();
}

} // namespace

bool Gain_of_examples::is_clear() const { return pairs > 0 && with - without > chance_gain / std::sqrt(double(pairs)); }

std::vector<Gain_of_examples> gains_of_examples(const Role_model& model, const std::vector<Labelled_graph>& shapes,
                                                const Role_training_options& options)
{
  std::map<std::string, std::vector<std::size_t>> categories;
  for (std::size_t i = 0; i < shapes.size(); ++i)
    categories[shapes[i].category].push_back(i);
  std::vector<Gain_of_examples> result;
  for (const auto& of_category : categories) {
    const std::string& category = of_category.first;
    const std::vector<Shape_pair> pairs = spread_pairs(of_category.second);
    std::vector<std::array<double, 2>> scores(pairs.size()); // with, without
    internal::for_each_index(pairs.size(), true, [&](std::size_t i) {
      const auto& [source, target] = pairs[i];
      std::vector<Labelled_graph> others;
      for (std::size_t shape : of_category.second)
        if (shape != source && shape != target) others.push_back(shapes[shape]);
      scores[i] = {f1(shapes[source], shapes[target], extend_role_model(model, others, options), category),
                   f1(shapes[source], shapes[target], model, "")};
    });
    Gain_of_examples gain{category, pairs.size()};
    for (const auto& [with, without] : scores) {
      gain.with += with / double(pairs.size());
      gain.without += without / double(pairs.size());
    }
    result.push_back(std::move(gain));
  }
  return result;
}

} // namespace CGAL::Shape_correspondence

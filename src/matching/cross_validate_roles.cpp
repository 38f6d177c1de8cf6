// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "matching/cross_validate_roles.h"
#include "base/for_each_index.h"
#include "matching/Role_trainer.h"
#include "matching/Shape_roles.h"

#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace CGAL::Shape_correspondence::internal {

namespace {

constexpr std::size_t least_shapes = 4; // of a category whose roles are trusted: with fewer, chance decides
constexpr double least_gain = 0.01;     // of F1, that more trust must bring

std::vector<char> left_out_shapes(const std::vector<Validation_shape>& shapes, const Validation_pair& pair,
                                  Left_out left_out)
{
  std::vector<char> result(shapes.size(), 0);
  for (std::size_t shape = 0; shape < shapes.size(); ++shape)
    for (std::size_t end : pair) {
      const bool same_category = shapes[shape].labelled.category == shapes[end].labelled.category;
      if (shape == end || (left_out == Left_out::SOURCES && shapes[shape].source == shapes[end].source) ||
          (left_out == Left_out::CATEGORY && same_category))
        result[shape] = 1;
    }
  return result;
}

std::vector<std::size_t> indices_of(const Eigen::MatrixXi& votes)
{
  std::vector<std::size_t> result(std::size_t(votes.rows()));
  std::iota(result.begin(), result.end(), std::size_t(0));
  return result;
}

// Matches by `Role_trust`.
std::array<Part_matching, 3> matchings(const Shape_roles& source, const Shape_roles& target,
                                       const Role_model_data& model, std::size_t category,
                                       const Part_matching& geometric)
{
  std::array<Part_matching, 3> result;
  result.fill(geometric);
  if (category == model.categories.size()) return result;
  const Eigen::MatrixXi &a = source.votes(category), &b = target.votes(category);
  for (Role_trust trust : {Role_trust::CONFIRM, Role_trust::FULL})
    join_roles(a, indices_of(a), b, indices_of(b), model, trust, result[std::size_t(trust)]);
  return result;
}

std::array<Correspondence_score, 3> scores(const std::array<Part_matching, 3>& matchings, const Ground_truth& truth)
{
  std::array<Correspondence_score, 3> result;
  for (std::size_t t = 0; t < result.size(); ++t)
    result[t] = evaluate_correspondence(part_pairs(matchings[t].pairs), truth);
  return result;
}

std::vector<Judged_pair> judged(const Part_matching& matching, const Ground_truth& truth)
{
  std::vector<Judged_pair> result;
  for (const Part_correspondence& pair : matching.pairs)
    result.push_back({pair.confidence, std::binary_search(truth.pairs.begin(), truth.pairs.end(),
                                                          std::make_pair(pair.source, pair.target))});
  return result;
}

// The nearest values that do not fall, by weighted squares (pool adjacent violators); a value of no weight is between
// its neighbours'.
Confidence_table isotonic(const Confidence_table& sums, const Confidence_table& weights)
{
  struct Pool
  {
    double sum, weight, at; // `at`: sum of weight times index
  };
  std::vector<Pool> pools;
  for (std::size_t i = 0; i < sums.size(); ++i) {
    if (!(weights[i] > 0)) continue;
    pools.push_back({sums[i], weights[i], weights[i] * double(i)});
    for (std::size_t last = pools.size() - 1;
         last > 0 && pools[last - 1].sum * pools[last].weight >= pools[last].sum * pools[last - 1].weight; --last) {
      pools[last - 1] = {pools[last - 1].sum + pools[last].sum, pools[last - 1].weight + pools[last].weight,
                         pools[last - 1].at + pools[last].at};
      pools.pop_back();
    }
  }
  Confidence_table result = uncalibrated_confidences;
  for (std::size_t i = 0; i < result.size() && !pools.empty(); ++i) {
    const auto place = [](const Pool& p) { return p.at / p.weight; };
    const auto next = std::find_if(pools.begin(), pools.end(), [&](const Pool& p) { return place(p) >= double(i); });
    const Pool &after = next == pools.end() ? pools.back() : *next,
               &before = next == pools.begin() ? pools.front() : *std::prev(next);
    const double from = place(before), to = place(after);
    const double t = to > from ? std::clamp((double(i) - from) / (to - from), 0., 1.) : 0;
    result[i] = before.sum / before.weight + t * (after.sum / after.weight - before.sum / before.weight);
  }
  return result;
}

} // namespace

Role_validation::Role_validation(const std::vector<Validation_shape>& shapes, const std::vector<Validation_pair>& pairs,
                                 Left_out left_out, const Role_training_options& options)
    : shapes_(shapes), pairs_(pairs.size())
{
  std::vector<Labelled_graph> labelled;
  for (const Validation_shape& shape : shapes)
    labelled.push_back(shape.labelled);
  const Role_trainer trainer(labelled, options);
  all_ = trainer.model();
  std::vector<std::array<Correspondence_score, 3>> found(pairs.size()); // in the category as the matcher finds it
  for_each_index(pairs.size(), true, [&](std::size_t i) {
    const Validation_pair& pair = pairs[i];
    const Validation_shape &source = shapes[pair[0]], &target = shapes[pair[1]];
    Role_model_data data = all_;
    const std::size_t own = data.index(source.labelled.category);
    data.categories[own] = trainer.category(source.labelled.category, left_out_shapes(shapes, pair, left_out));
    if (data.categories[own].roles.empty()) data.categories.erase(data.categories.begin() + std::ptrdiff_t(own));
    const Role_model model(std::move(data));
    const Shape_roles a(trainer.features(pair[0]), model), b(trainer.features(pair[1]), model);
    Part_matching geometric;
    geometric.pairs = find_correspondence(*source.labelled.graph, *target.labelled.graph).pairs;
    const Ground_truth truth = ground_truth(source.labels, target.labels);
    const std::size_t told = model.data().index(source.labelled.category),
                      category = category_of_pair(a, b, model.data()).index;
    pairs_[i].shapes = pair;
    const std::array<Part_matching, 3> as_told = matchings(a, b, model.data(), told, geometric);
    pairs_[i].scores = scores(as_told, truth);
    for (std::size_t t = 0; t < as_told.size(); ++t)
      pairs_[i].judged[t] = judged(as_told[t], truth);
    if (category < model.data().categories.size()) pairs_[i].category = model.data().categories[category].name;
    found[i] = category == told ? pairs_[i].scores : scores(matchings(a, b, model.data(), category, geometric), truth);
  });
  for (const Validated_pair& pair : pairs_)
    told_.push_back(pair.scores);
  // A category that was left out tells nothing of how far others are to be trusted
  if (left_out == Left_out::CATEGORY) told_ = Role_validation(shapes, pairs, Left_out::SHAPES, options).told_;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    std::vector<char> is_left_out(shapes.size(), 0);
    for (std::size_t end : pairs[i])
      is_left_out[end] = 1;
    if (!pairs_[i].category.empty()) pairs_[i].trust = trust(pairs_[i].category, is_left_out);
    pairs_[i].joined = found[i][std::size_t(pairs_[i].trust)];
  }
}

Role_model Role_validation::model() const
{
  Role_model_data result = all_;
  for (Category_roles& category : result.categories)
    category.trust = trust(category.name);
  result.confidences = confidences();
  return Role_model(std::move(result));
}

// Of left-out pairs of shapes, of which each weighs the same within its category, and every category the same.
Confidence_table Role_validation::confidences() const
{
  std::map<std::string, std::vector<const std::vector<Judged_pair>*>> by_category;
  for (const Validated_pair& pair : pairs_) {
    const std::string& category = shapes_[pair.shapes[0]].labelled.category;
    const std::vector<Judged_pair>& judged = pair.judged[std::size_t(trust(category))];
    if (trust(category) != Role_trust::NONE && !judged.empty()) by_category[category].push_back(&judged);
  }
  Confidence_table right{}, weights{};
  for (const auto& [category, matches] : by_category)
    for (const std::vector<Judged_pair>* match : matches)
      for (const Judged_pair& pair : *match) {
        const std::size_t i = std::size_t(std::lround(pair.same_role * double(weights.size() - 1)));
        const double weight = 1 / double(matches.size() * match->size());
        weights[i] += weight;
        right[i] += pair.is_right ? weight : 0;
      }
  return isotonic(right, weights);
}

Role_trust Role_validation::trust(const std::string& category) const
{
  return trust(category, std::vector<char>(shapes_.size(), 0));
}

Role_trust Role_validation::trust(const std::string& category, const std::vector<char>& is_left_out) const
{
  std::array<double, 3> f1{};
  std::set<std::size_t> seen;
  std::size_t count = 0;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    const Validated_pair& pair = pairs_[i];
    if (shapes_[pair.shapes[0]].labelled.category != category || is_left_out[pair.shapes[0]] ||
        is_left_out[pair.shapes[1]])
      continue;
    ++count;
    seen.insert(pair.shapes.begin(), pair.shapes.end());
    for (std::size_t t = 0; t < f1.size(); ++t)
      f1[t] += told_[i][t].f1();
  }
  std::size_t best = 0;
  for (std::size_t t = 1; t < f1.size() && seen.size() >= least_shapes; ++t)
    if (f1[t] >= f1[best] + least_gain * double(count)) best = t;
  return Role_trust(best);
}

} // namespace CGAL::Shape_correspondence::internal

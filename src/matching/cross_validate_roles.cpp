// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "matching/cross_validate_roles.h"
#include "base/for_each_index.h"
#include "matching/Pair_validator.h"
#include "matching/aligned_matching.h"
#include "matching/match_by_roles.h"

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <utility>

namespace CGAL::Shape_correspondence::internal {

namespace {

constexpr std::size_t least_pairs = 50; // of shapes, that weights are fitted to: with fewer, chance decides
constexpr double slight_charge = 1e-4;  // for large weights, where every category weighs 1: keeps them finite
// For weights of a category that are not those of the others: as strong as one shape. Set by cross-validation, where it
// is flat.
constexpr double charge_of_category = 1;
// The same of the offset of confidences: what share of a category's pairs is right differs more than how it grows.
constexpr double charge_of_offset = 0.25;

Confidence_weights confidence_charges() { return {charge_of_category, charge_of_offset}; }

// By index in the structural graphs.
Part_matching geometric_match(const Structural_graph& source, const Structural_graph& target,
                              const Part_matching_options& options)
{
  const Aligned_shape a = align_shape(source, given_quarter_turns(structure(source).frame)),
                      b = align_shape(target, given_quarter_turns(structure(target).frame));
  const Part_matching aligned = match_parts(a, b, options);
  Part_matching result;
  for (const Part_correspondence& pair : aligned.pairs)
    result.pairs.push_back({a.original[pair.source], b.original[pair.target], pair.confidence});
  result.costs.resize(aligned.costs.rows(), aligned.costs.cols());
  for (Eigen::Index i = 0; i < result.costs.rows(); ++i)
    for (Eigen::Index j = 0; j < result.costs.cols(); ++j)
      result.costs(Eigen::Index(a.original[std::size_t(i)]), Eigen::Index(b.original[std::size_t(j)])) =
          aligned.costs(i, j);
  return result;
}

Judged_terms judged_terms(Pair_terms terms, const Ground_truth& truth, std::size_t target_size)
{
  Judged_terms result{std::move(terms), {}};
  result.is_right = Eigen::ArrayXd::Zero(result.terms.rows());
  for (const auto& [i, j] : truth.pairs)
    result.is_right[Eigen::Index(i * target_size + j)] = 1;
  return result;
}

std::vector<Judged_pair> judged(const std::vector<Part_correspondence>& pairs, const Ground_truth& truth)
{
  const auto has = [](const Part_pairs& known, const Part_correspondence& pair) {
    return std::binary_search(known.begin(), known.end(), std::make_pair(pair.source, pair.target));
  };
  std::vector<Judged_pair> result;
  for (const Part_correspondence& pair : pairs)
    result.push_back({pair.confidence, has(truth.pairs, pair), has(truth.coarse_pairs, pair)});
  return result;
}

Judged_confidences judged_confidences(const Part_matching& matching, const Ground_truth& truth)
{
  const std::vector<Judged_pair> pairs = judged(matching.pairs, truth);
  Judged_confidences result;
  result.terms.resize(Eigen::Index(pairs.size()), CONFIDENCE_TERM_COUNT);
  result.is_right.resize(Eigen::Index(pairs.size()));
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    result.terms.row(Eigen::Index(k)) = confidence_terms(pairs[k].confidence);
    result.is_right[Eigen::Index(k)] = pairs[k].is_right;
  }
  return result;
}

// The share of the target's parts that get their coarse label from the source.
double transferred_share(const Part_matching& matching, const Validation_shape& source, const Validation_shape& target)
{
  const std::vector<Part_label>&from = source.labelled.labels, &to = target.labelled.labels;
  std::size_t right = 0;
  for (std::size_t j = 0; j < to.size(); ++j)
    right += from[likeliest_source(matching, j).source].coarse == to[j].coarse;
  return double(right) / double(to.size());
}

std::vector<Labelled_graph> labelled_graphs(const std::vector<Validation_shape>& shapes)
{
  std::vector<Labelled_graph> result;
  for (const Validation_shape& shape : shapes)
    result.push_back(shape.labelled);
  return result;
}

} // namespace

Role_validation::Role_validation(const std::vector<Validation_shape>& shapes, const std::vector<Validation_pair>& pairs,
                                 const Validation_options& options, const Role_training_options& training)
    : shapes_(shapes), options_(options), labelled_(labelled_graphs(shapes)), pairs_(pairs.size())
{
  validator_ = std::make_unique<Pair_validator>(shapes, labelled_, training);
  evidence_ = validator_->run(pairs, options);
  for (std::size_t i = 0; i < pairs.size(); ++i)
    pairs_[i].shapes = pairs[i];
  // What was learned with much left out tells nothing of how good what is learned of others is
  if (options.left_out != Left_out::SHAPES && !options.examples) with_others_ = validator_->run(pairs, {});
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    categories_.push_back(shapes[pairs[i][0]].labelled.category);
    nearest_.push_back((with_others_.empty() ? evidence_ : with_others_)[i].nearest);
  }
  match({});
}

Role_validation::~Role_validation() = default;

void Role_validation::match(const Part_matching_options& parts)
{
  const std::vector<Pair_evidence>& seen = with_others_.empty() ? evidence_ : with_others_;
  const auto shapes_of = [&](std::size_t i) {
    return std::vector<std::size_t>(pairs_[i].shapes.begin(), pairs_[i].shapes.end());
  };
  const auto shapes_of_category = [&](const std::string& category) {
    std::vector<std::size_t> result;
    for (std::size_t shape = 0; shape < shapes_.size(); ++shape)
      if (shapes_[shape].labelled.category == category) result.push_back(shape);
    return result;
  };
  std::vector<Part_matching> geometric(pairs_.size());
  examples_.assign(pairs_.size(), {});
  for_each_index(pairs_.size(), true, [&](std::size_t i) {
    const auto& [source, target] = pairs_[i].shapes;
    geometric[i] = geometric_match(*shapes_[source].labelled.graph, *shapes_[target].labelled.graph, parts);
    if (seen[i].told.rows() > 0)
      examples_[i] = judged_terms(with_geometric_terms(seen[i].told, geometric[i].costs, geometric[i].pairs),
                                  seen[i].truth, seen[i].target_size);
  });

  std::map<std::string, Pair_weights> of_others;
  for (std::size_t i = 0; i < pairs_.size(); ++i)
    if (of_others.count(categories_[i]) == 0) of_others[categories_[i]] = weights_without(categories_[i]);
  std::vector<Pair_weights> own_weights(pairs_.size());
  confidences_.assign(pairs_.size(), {});
  geometric_confidences_.assign(pairs_.size(), {});
  for_each_index(pairs_.size(), true, [&](std::size_t i) {
    own_weights[i] = of_others.at(categories_[i]);
    if (!options_.examples) own_weights[i] = weights_of(categories_[i], own_weights[i], shapes_of(i));
    if (seen[i].category.empty()) geometric_confidences_[i] = judged_confidences(geometric[i], seen[i].truth);
    if (seen[i].category != categories_[i]) return;
    const Pair_terms terms = with_geometric_terms(seen[i].found, geometric[i].costs, geometric[i].pairs);
    confidences_[i] = judged_confidences(match_by_terms(terms, own_weights[i], geometric[i], {}, parts), seen[i].truth);
  });
  std::map<std::string, Confidence_weights> confidence_of_others, geometric_confidence;
  for (const auto& [category, weights] : of_others) {
    confidence_of_others[category] = confidence_without(category, confidences_);
    geometric_confidence[category] = confidence_without(category, geometric_confidences_);
  }

  for_each_index(pairs_.size(), true, [&](std::size_t i) {
    const std::string& category = categories_[i];
    const Pair_evidence& pair = evidence_[i];
    Validated_pair& result = pairs_[i];
    Pair_weights weights = of_others.at(category);
    Confidence_weights stated = confidence_of_others.at(category);
    if (pair.told.rows() > 0 && (pair.category == category || options_.orients_shapes())) {
      weights = own_weights[i];
      if (!options_.examples) stated = confidence_of(category, stated, shapes_of(i));
    }
    Part_matching matched = geometric[i];
    std::vector<Part_correspondence> without = geometric[i].pairs;
    result.category = pair.category;
    if (options_.orients_shapes()) {
      Turned_match found = validator_->turned_match(result.shapes, i, options_, parts, weights, stated);
      without = std::move(found.without_roles);
      matched.pairs = std::move(found.with_roles);
      result.category = std::move(found.category);
    } else if (!pair.category.empty()) {
      matched = match_by_terms(with_geometric_terms(pair.found, geometric[i].costs, geometric[i].pairs), weights,
                               geometric[i], {}, parts);
      state_confidences(stated, matched);
    } else {
      Confidence_weights geometric_stated = geometric_confidence.at(category);
      if (!options_.examples)
        geometric_stated = geometric_confidence_of(
            pair.nearest, geometric_stated,
            options_.left_out == Left_out::CATEGORY ? shapes_of_category(category) : shapes_of(i));
      state_confidences(geometric_stated, matched);
    }
    if (options_.role_weight > 0) {
      without = pair.least_energy[0];
      matched.pairs = pair.least_energy[1];
    }
    const Validation_shape &source = shapes_[result.shapes[0]], &target = shapes_[result.shapes[1]];
    result.geometric = evaluate_correspondence(part_pairs(without), pair.truth);
    result.joined = evaluate_correspondence(part_pairs(matched.pairs), pair.truth);
    result.labels_by_geometry = transferred_share(geometric[i], source, target);
    result.labels_joined = transferred_share(matched, source, target);
    result.fronts = pair.fronts;
    if (options_.role_weight == 0) result.judged = judged(matched.pairs, pair.truth);
  });
}

Pair_weights Role_validation::weights() const { return weights_without(""); }

Role_model Role_validation::model() const
{
  Role_model_data result = validator_->model();
  for (Category_roles& category : result.categories) {
    category.weights = weights_of(category.name, weights_without(category.name), {});
    category.confidence = confidence_of(category.name, confidence_without(category.name, confidences_), {});
    category.geometric_confidence =
        geometric_confidence_of(category.name, confidence_without(category.name, geometric_confidences_), {});
  }
  result.geometric_confidence = confidence_without("", geometric_confidences_);
  return Role_model(std::move(result));
}

namespace {

// A fit, and how many pairs of shapes it is of.
template <typename Weights>
struct Fit
{
  Weights weights;
  std::size_t pairs;
};

} // namespace

// Every category weighs the same, and every pair of shapes within it.
template <typename Examples>
auto Role_validation::fitted_without(const std::string& left_out, const Examples& examples) const
{
  using Example = typename Examples::value_type;
  constexpr int term_count = decltype(Example::terms)::ColsAtCompileTime;
  using Weights = Eigen::Matrix<double, term_count, 1>;
  std::map<std::string, std::vector<const Example*>> by_category;
  std::size_t count = 0;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    if (categories_[i] == left_out || examples[i].terms.rows() == 0) continue;
    by_category[categories_[i]].push_back(&examples[i]);
    ++count;
  }
  std::vector<Weighted<term_count>> chosen;
  for (const auto& [category, of_category] : by_category)
    for (const Example* example : of_category)
      chosen.push_back({example, 1 / double(of_category.size())});
  return Fit<Weights>{fitted_weights<term_count>(chosen, Weights::Zero(), Weights::Constant(slight_charge)), count};
}

// Every shape weighs 1.
template <typename Examples, typename Weights>
Weights Role_validation::fitted_of(const std::string& category, const std::vector<std::string>& group,
                                   const Examples& examples, const Weights& expected, const Weights& charges,
                                   const std::vector<std::size_t>& left_out) const
{
  constexpr int term_count = Weights::RowsAtCompileTime;
  const auto is_left_out = [&](std::size_t shape) {
    return std::find(left_out.begin(), left_out.end(), shape) != left_out.end();
  };
  std::vector<const typename Examples::value_type*> of_category;
  std::set<std::size_t> seen;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    const Validation_pair& pair = pairs_[i].shapes;
    if (group[i] != category || examples[i].terms.rows() == 0 || is_left_out(pair[0]) || is_left_out(pair[1])) continue;
    of_category.push_back(&examples[i]);
    seen.insert(pair.begin(), pair.end());
  }
  std::vector<Weighted<term_count>> chosen;
  for (const auto* example : of_category)
    chosen.push_back({example, double(seen.size()) / double(of_category.size())});
  return fitted_weights<term_count>(chosen, expected, charges);
}

Pair_weights Role_validation::weights_without(const std::string& left_out) const
{
  const auto [weights, pairs] = fitted_without(left_out, examples_);
  return pairs < least_pairs ? usual_pair_weights() : weights;
}

Pair_weights Role_validation::weights_of(const std::string& category, const Pair_weights& expected,
                                         const std::vector<std::size_t>& left_out) const
{
  return fitted_of(category, categories_, examples_, expected, Pair_weights(Pair_weights::Constant(charge_of_category)),
                   left_out);
}

Confidence_weights Role_validation::confidence_without(const std::string& left_out,
                                                       const std::vector<Judged_confidences>& examples) const
{
  const auto [weights, pairs] = fitted_without(left_out, examples);
  return pairs < least_pairs ? usual_confidence_weights() : weights;
}

Confidence_weights Role_validation::confidence_of(const std::string& category, const Confidence_weights& expected,
                                                  const std::vector<std::size_t>& left_out) const
{
  return fitted_of(category, categories_, confidences_, expected, confidence_charges(), left_out);
}

Confidence_weights Role_validation::geometric_confidence_of(const std::string& nearest,
                                                            const Confidence_weights& expected,
                                                            const std::vector<std::size_t>& left_out) const
{
  return fitted_of(nearest, nearest_, geometric_confidences_, expected, confidence_charges(), left_out);
}

} // namespace CGAL::Shape_correspondence::internal

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Shape_correspondence/train_role_model.h>

#include "base/for_each_index.h"
#include "matching/Role_fit.h"
#include "matching/aligned_matching.h"
#include "roles/Role_trainer.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

namespace CGAL::Shape_correspondence {
using namespace internal;

namespace internal {

namespace {

constexpr std::size_t least_pairs = 50; // of shapes, that weights are fitted to: with fewer, chance decides
constexpr double slight_penalty = 1e-4; // for large weights, where every category weighs 1: keeps them finite
// For weights of a category that are not those of the others: as strong as one shape. Set by cross-validation, where it
// is flat.
constexpr double category_penalty = 1;
// The same of the offset of confidences: what share of a category's pairs is right differs more than how it grows.
constexpr double offset_penalty = 0.25;

Confidence_weights confidence_penalties() { return {category_penalty, offset_penalty}; }

Pair_terms role_terms_of_all(const Role_votes& source, const Role_votes& target)
{
  const auto all = [](const Role_votes& votes) {
    std::vector<std::size_t> result(votes.labels.size());
    std::iota(result.begin(), result.end(), std::size_t(0));
    return result;
  };
  return role_terms(source, all(source), target, all(target));
}

Judged_terms judged_terms(Pair_terms terms, const Ground_truth& truth, Eigen::Index target_size)
{
  Judged_terms result{std::move(terms), {}};
  result.is_right = Eigen::ArrayXd::Zero(result.terms.rows());
  for (const auto& [i, j] : truth.pairs)
    result.is_right[Eigen::Index(i) * target_size + Eigen::Index(j)] = 1;
  return result;
}

Judged_confidences judged_confidences(const std::vector<Part_correspondence>& pairs, const Ground_truth& truth)
{
  Judged_confidences result;
  result.terms.resize(Eigen::Index(pairs.size()), CONFIDENCE_TERM_COUNT);
  result.is_right.resize(Eigen::Index(pairs.size()));
  for (Eigen::Index k = 0; k < result.is_right.size(); ++k) {
    const Part_correspondence& pair = pairs[std::size_t(k)];
    result.terms.row(k) = confidence_terms(pair.confidence);
    result.is_right[k] =
        std::binary_search(truth.pairs.begin(), truth.pairs.end(), std::make_pair(pair.source, pair.target));
  }
  return result;
}

} // namespace

Unseen_pair unseen_pair(const std::vector<Labelled_graph>& shapes, const Shape_pair& pair, const Shape_roles& source,
                        const Shape_roles& target, const Role_model_data& model, bool category_known)
{
  const Labelled_graph &a = shapes[pair[0]], &b = shapes[pair[1]];
  Unseen_pair result{pair, a.category, ground_truth(a.labels, b.labels), {}, {}, {}, {}};
  const std::size_t own = model.index(a.category), none = model.categories.size();
  const Pair_category of_pair = category_of_pair(source, target, model);
  const std::size_t found = category_known ? own : of_pair.index;
  if (of_pair.nearest < none) result.nearest = model.categories[of_pair.nearest].name;
  if (own < none) result.own_terms = role_terms_of_all(source.votes(own), target.votes(own));
  if (found == none) return result;
  result.found = model.categories[found].name;
  result.found_terms = found == own ? result.own_terms : role_terms_of_all(source.votes(found), target.votes(found));
  return result;
}

Part_matching geometric_match(const Structural_graph& source, const Structural_graph& target,
                              const Part_matching_options& options)
{
  const Aligned_shape a = align_shape(source, given_quarter_turns(structure(source).frame)),
                      b = align_shape(target, given_quarter_turns(structure(target).frame));
  return renumbered(match_parts(a, b, options), a.original, b.original);
}

template <typename Examples>
auto Role_fit::fitted_without(const std::string& left_out, const Examples& examples) const
{
  using Example = typename Examples::value_type;
  constexpr int term_count = decltype(Example::terms)::ColsAtCompileTime;
  using Weights = Eigen::Matrix<double, term_count, 1>;
  std::map<std::string, std::vector<const Example*>> by_category;
  std::size_t count = 0;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    if (pairs_[i].category == left_out || examples[i].terms.rows() == 0) continue;
    by_category[pairs_[i].category].push_back(&examples[i]);
    ++count;
  }
  if (count < least_pairs) {
    if constexpr (term_count == PAIR_TERM_COUNT)
      return usual_pair_weights();
    else
      return usual_confidence_weights();
  }
  std::vector<Weighted<term_count>> chosen;
  for (const auto& [category, of_category] : by_category)
    for (const Example* example : of_category)
      chosen.push_back({example, 1 / double(of_category.size())});
  return fitted_weights<term_count>(chosen, Weights::Zero(), Weights::Constant(slight_penalty));
}

// Every shape weighs 1.
template <typename Examples, typename Weights>
Weights Role_fit::fitted_of(const std::string& category, std::string Unseen_pair::*group, const Examples& examples,
                            const Weights& expected, const Weights& penalties,
                            const std::vector<std::size_t>& left_out) const
{
  if (!by_category_) return expected;
  constexpr int term_count = Weights::RowsAtCompileTime;
  const auto is_left_out = [&](std::size_t shape) {
    return std::find(left_out.begin(), left_out.end(), shape) != left_out.end();
  };
  std::vector<const typename Examples::value_type*> of_category;
  std::set<std::size_t> seen;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    const Shape_pair& pair = pairs_[i].shapes;
    if (pairs_[i].*group != category || examples[i].terms.rows() == 0 || is_left_out(pair[0]) || is_left_out(pair[1]))
      continue;
    of_category.push_back(&examples[i]);
    seen.insert(pair.begin(), pair.end());
  }
  std::vector<Weighted<term_count>> chosen;
  for (const auto* example : of_category)
    chosen.push_back({example, double(seen.size()) / double(of_category.size())});
  return fitted_weights<term_count>(chosen, expected, penalties);
}

Role_fit::Role_fit(const std::vector<Unseen_pair>& pairs, const std::vector<Part_matching>& geometric,
                   const Part_matching_options& options, bool by_category)
    : pairs_(pairs),
      by_category_(by_category),
      terms_(pairs.size()),
      weights_of_pair_(pairs.size()),
      confidences_(pairs.size()),
      geometric_confidences_(pairs.size())
{
  const auto with_geometry = [&](const Pair_terms& terms, std::size_t i) {
    return with_geometric_terms(terms, geometric[i].costs, geometric[i].pairs);
  };
  for_each_index(pairs.size(), true, [&](std::size_t i) {
    if (pairs[i].own_terms.rows() > 0)
      terms_[i] = judged_terms(with_geometry(pairs[i].own_terms, i), pairs[i].truth, geometric[i].costs.cols());
  });
  for (const Unseen_pair& pair : pairs)
    if (of_others_.count(pair.category) == 0) of_others_[pair.category].weights = fitted_without(pair.category, terms_);
  for_each_index(pairs.size(), true, [&](std::size_t i) {
    const Unseen_pair& pair = pairs[i];
    weights_of_pair_[i] = weights(pair.category, {pair.shapes.begin(), pair.shapes.end()});
    if (pair.found.empty()) geometric_confidences_[i] = judged_confidences(geometric[i].pairs, pair.truth);
    if (pair.found != pair.category) return;
    const Pair_terms terms = with_geometry(pair.found_terms, i);
    confidences_[i] =
        judged_confidences(match_by_terms(terms, weights_of_pair_[i], geometric[i], {}, options).pairs, pair.truth);
  });
  for (auto& [category, weights] : of_others_) {
    weights.confidence = fitted_without(category, confidences_);
    weights.geometric_confidence = fitted_without(category, geometric_confidences_);
  }
}

Match_weights Role_fit::of_others(const std::string& category) const
{
  const auto known = of_others_.find(category);
  if (known != of_others_.end()) return known->second;
  return {fitted_without(category, terms_), fitted_without(category, confidences_),
          fitted_without(category, geometric_confidences_)};
}

Pair_weights Role_fit::weights(const std::string& category, const std::vector<std::size_t>& left_out) const
{
  return fitted_of(category, &Unseen_pair::category, terms_, of_others(category).weights,
                   Pair_weights(Pair_weights::Constant(category_penalty)), left_out);
}

Confidence_weights Role_fit::confidence(const std::string& category, const std::vector<std::size_t>& left_out) const
{
  return fitted_of(category, &Unseen_pair::category, confidences_, of_others(category).confidence,
                   confidence_penalties(), left_out);
}

Confidence_weights Role_fit::geometric_confidence(const std::string& nearest, const std::string& category,
                                                  const std::vector<std::size_t>& left_out) const
{
  return fitted_of(nearest, &Unseen_pair::nearest, geometric_confidences_, of_others(category).geometric_confidence,
                   confidence_penalties(), left_out);
}

void Role_fit::apply(Role_model_data& model) const
{
  for (Category_roles& category : model.categories) {
    const std::string& name = category.name;
    static_cast<Match_weights&>(category) = {weights(name, {}), confidence(name, {}),
                                             geometric_confidence(name, name, {})};
  }
  model.geometric_confidence = of_others("").geometric_confidence;
}

} // namespace internal

namespace {

void check(const std::vector<Labelled_graph>& shapes, const Shape_pair& pair)
{
  if (pair[0] >= shapes.size() || pair[1] >= shapes.size() || pair[0] == pair[1] ||
      shapes[pair[0]].category != shapes[pair[1]].category)
    throw Invalid_input("train_role_model: the pair " + std::to_string(pair[0]) + ", " + std::to_string(pair[1]) +
                        " is not of two shapes of a category; give pairs that are");
}

// What a model learned from all other shapes predicts for a pair. \param all learned from all shapes
Unseen_pair predicted_without(const std::vector<Labelled_graph>& shapes, const Shape_pair& pair,
                              const Role_trainer& trainer, const Role_model_data& all)
{
  std::vector<char> is_left_out(shapes.size(), 0);
  is_left_out[pair[0]] = is_left_out[pair[1]] = 1;
  const Role_model model = Role_model_access::model(trainer.model_without(all, shapes[pair[0]].category, is_left_out));
  return unseen_pair(shapes, pair, Shape_roles(trainer.evidence(pair[0]), model),
                     Shape_roles(trainer.evidence(pair[1]), model), Role_model_access::data(model));
}

} // namespace

Role_model train_role_model(const std::vector<Labelled_graph>& shapes, const Role_training_options& options,
                            const std::vector<Shape_pair>& pairs)
{
  for (const Shape_pair& pair : pairs)
    check(shapes, pair);
  const Role_trainer trainer(shapes, options);
  Role_model_data model = trainer.model();
  if (!pairs.empty()) {
    std::vector<Unseen_pair> unseen(pairs.size());
    std::vector<Part_matching> geometric(pairs.size());
    for_each_index(pairs.size(), true, [&](std::size_t i) {
      unseen[i] = predicted_without(shapes, pairs[i], trainer, model);
      geometric[i] = geometric_match(*shapes[pairs[i][0]].graph, *shapes[pairs[i][1]].graph);
    });
    Role_fit(unseen, geometric).apply(model);
  }
  return Role_model_access::model(std::move(model));
}

Role_model extend_role_model(const Role_model& model, const std::vector<Labelled_graph>& shapes,
                             const Role_training_options& options)
{
  Role_training_options of_all = options;
  const Role_model_data& known = Role_model_access::data(model);
  if (!known.categories.empty()) of_all.trees = known.trees;
  return Role_model_access::model(Role_trainer(shapes, of_all, known).model());
}

} // namespace CGAL::Shape_correspondence

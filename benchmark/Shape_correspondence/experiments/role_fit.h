// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

// Fits the weights of matching with roles to pairs of shapes. Roles are found by models learned without these shapes.
#pragma once

#include "base/for_each_index.h"
#include "matching/aligned_matching.h"
#include "roles/Role_trainer.h"
#include "roles/Shape_roles.h"

#include <CGAL/Shape_correspondence/ground_truth.h>

#include <Eigen/Cholesky>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::experiments {

using namespace internal;

constexpr int newton_steps = 15;       // largest number of steps
constexpr double newton_change = 1e-9; // the iteration ends if all weights change by less

constexpr std::size_t least_pairs = 50; // least number of pairs of shapes to fit; with fewer: usual weights
constexpr double slight_penalty = 1e-4; // penalty on squared weights, which keeps them finite
// Penalty on squared differences of the weights of a category from the weights fitted to all other categories. The
// pairs of the category have a total weight of 1 for each of its shapes. Chosen by cross-validation, whose score hardly
// depends on it.
constexpr double category_penalty = 1;
// The same penalty for the weights that calibrate confidences. It is higher, since the shapes of a category are from
// few sources, which differ from each other.
constexpr double confidence_penalty = 16;

// Terms of pairs of parts of two shapes, and whether each pair is in the ground truth.
template <int term_count>
struct Judged
{
  Eigen::Matrix<double, Eigen::Dynamic, term_count> terms;
  Eigen::ArrayXd is_right; // 1 or 0
};
using Judged_terms = Judged<PAIR_TERM_COUNT>;
using Judged_confidences = Judged<CONFIDENCE_TERM_COUNT>;

// The pairs of parts of two shapes, and their total weight in a fit.
template <int term_count>
struct Weighted
{
  const Judged<term_count>* judged;
  double weight;
};

// Weights of a logistic regression by Newton's method, with a quadratic penalty on the distance of each weight from its
// expected value; rounded to multiples of `pair_weight_unit`.
template <int term_count>
Eigen::Matrix<double, term_count, 1> fitted_weights(const std::vector<Weighted<term_count>>& examples,
                                                    const Eigen::Matrix<double, term_count, 1>& expected,
                                                    const Eigen::Matrix<double, term_count, 1>& penalties)
{
  using Weights = Eigen::Matrix<double, term_count, 1>;
  using Hessian = Eigen::Matrix<double, term_count, term_count>;
  Weights weights = expected;
  for (int step = 0; step < newton_steps; ++step) {
    Weights gradient = penalties.cwiseProduct(expected - weights);
    Hessian hessian = penalties.asDiagonal();
    for (const auto& [judged, weight_of_all] : examples) {
      const Eigen::ArrayXd p = 1 / (1 + (-(judged->terms * weights).array()).exp());
      const double weight = weight_of_all / double(p.size());
      gradient += weight * (judged->terms.transpose() * (judged->is_right - p).matrix());
      hessian += weight * (judged->terms.transpose() * (p * (1 - p)).matrix().asDiagonal() * judged->terms);
    }
    const Weights change = hessian.ldlt().solve(gradient);
    weights += change;
    if (change.cwiseAbs().maxCoeff() < newton_change) break;
  }
  return (weights / pair_weight_unit).array().round().matrix() * pair_weight_unit;
}

inline Pair_terms role_terms_of_all(const Role_votes& source, const Role_votes& target)
{
  const auto all = [](const Role_votes& votes) {
    std::vector<std::size_t> result(votes.labels.size());
    std::iota(result.begin(), result.end(), std::size_t(0));
    return result;
  };
  return role_terms(source, all(source), target, all(target));
}

inline Judged_terms judged_terms(Pair_terms terms, const Ground_truth& truth, Eigen::Index target_size)
{
  Judged_terms result{std::move(terms), {}};
  result.is_right = Eigen::ArrayXd::Zero(result.terms.rows());
  for (const auto& [i, j] : truth.pairs)
    result.is_right[Eigen::Index(i) * target_size + Eigen::Index(j)] = 1;
  return result;
}

inline Judged_confidences judged_confidences(const std::vector<Part_correspondence>& pairs, const Ground_truth& truth)
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

// Two labelled shapes of a category, by index.
using Shape_pair = std::array<std::size_t, 2>;

// A pair of labelled shapes, and the predictions of a model that was learned without them. Its terms are by roles only:
// those by the geometric match are added where weights are fitted or used.
struct Unseen_pair
{
  Shape_pair shapes{};
  std::string category;              // of both shapes
  Ground_truth truth;                // by their labels
  Pair_terms own_terms;              // for all pairs of parts, by the roles of `category`; empty if the model lacks it
  std::string found;                 // category that the model finds; empty: none
  Pair_terms found_terms;            // the same by the roles of the category `found`
  std::string nearest;               // nearest category, even if others are almost as near
  std::array<double, 2> distances{}; // distances from the two nearest categories, mean of both shapes
};

// \param source, target roles of the two shapes by `model` \param category_known whether their category is given
inline Unseen_pair unseen_pair(const std::vector<Labelled_graph>& shapes, const Shape_pair& pair,
                               const Shape_roles& source, const Shape_roles& target, const Role_model_data& model,
                               bool category_known = false)
{
  const Labelled_graph &a = shapes[pair[0]], &b = shapes[pair[1]];
  Unseen_pair result{pair, a.category, ground_truth(a.labels, b.labels), {}, {}, {}, {}, {}};
  const std::size_t own = model.index(a.category), none = model.categories.size();
  const Pair_category of_pair = category_of_pair(source, target, model);
  const std::size_t found = category_known ? own : of_pair.index;
  if (of_pair.nearest < none) result.nearest = model.categories[of_pair.nearest].name;
  std::vector<double> distances(2, 1e9); // greater than any distance
  for (std::size_t category = 0; category < none; ++category)
    distances.push_back((source.distance(category) + target.distance(category)) / 2);
  std::partial_sort(distances.begin(), distances.begin() + 2, distances.end());
  result.distances = {distances[0], distances[1]};
  if (own < none) result.own_terms = role_terms_of_all(source.votes(own), target.votes(own));
  if (found == none) return result;
  result.found = model.categories[found].name;
  result.found_terms = found == own ? result.own_terms : role_terms_of_all(source.votes(found), target.votes(found));
  return result;
}

// The match by geometry alone; parts have their indices in the structural graphs.
inline Part_matching geometric_match(const Structural_graph& source, const Structural_graph& target,
                                     const Part_matching_options& options = {})
{
  const Aligned_shape a = align_shape(source, given_quarter_turns(structure(source).frame)),
                      b = align_shape(target, given_quarter_turns(structure(target).frame));
  return renumbered(match_parts(a, b, options), a.original, b.original);
}

// Numbers of sources of shapes, such as packs and artists.
using Sources = std::set<std::size_t>;

// Fits the weights of all categories, for all shapes and without the sources of each pair.
class Role_fit
{
public:
  // \param pairs pairs of shapes, kept by reference \param geometric their geometric matches
  // \param sources number of the source of every shape, kept by reference
  // \param by_category whether the weights of a category may differ from those of all others
  Role_fit(const std::vector<Unseen_pair>& pairs, const std::vector<Part_matching>& geometric,
           const std::vector<std::size_t>& sources, const Part_matching_options& options = {}, bool by_category = true);

  // The weights fitted to the pairs of a category that have no shape of the sources left out. The fewer shapes these
  // pairs have, the nearer are the weights to those fitted to all other categories (which count equally, as do the
  // pairs within each). If the other categories have fewer than `least_pairs` pairs, the usual weights replace theirs.
  const Match_weights& weights(const std::string& category, const Sources& left_out) const;

  Sources sources_of(const Shape_pair& pair) const { return {sources_[pair[0]], sources_[pair[1]]}; }
  // Whether a shape of the pair is from one of the sources.
  bool has(const Shape_pair& pair, const Sources& sources) const
  {
    return sources.count(sources_[pair[0]]) > 0 || sources.count(sources_[pair[1]]) > 0;
  }

  // Sets the weights of all categories of a model, and those for shapes without a category.
  void apply(Role_model_data& model) const;

private:
  using Key = std::pair<std::string, Sources>;

  // Weights fitted to all categories but that of `key`. \param examples terms by pair of shapes
  template <typename Examples>
  auto fitted_without(const Key& key, const Examples& examples) const;
  // Weights fitted to the pairs whose member `group` is the category of `key`, near the expected weights
  template <typename Examples, typename Weights>
  Weights fitted_of(const Key& key, std::string Unseen_pair::*group, const Examples& examples, const Weights& expected,
                    const Weights& penalties) const;
  // Calls `set(key, weights)` for all keys, in parallel.
  template <typename Set>
  void for_each_key(const Set& set);

  const std::vector<Unseen_pair>& pairs_;
  const std::vector<std::size_t>& sources_;
  bool by_category_;
  std::vector<Judged_terms> terms_; // by pair of shapes, with the roles of its own category
  // By pair of shapes: pairs of parts matched by roles (empty if another category is found), and by geometry alone
  std::vector<Judged_confidences> confidences_, geometric_confidences_;
  std::map<Key, Match_weights> weights_;
};

template <typename Examples>
auto Role_fit::fitted_without(const Key& key, const Examples& examples) const
{
  using Example = typename Examples::value_type;
  constexpr int term_count = decltype(Example::terms)::ColsAtCompileTime;
  using Weights = Eigen::Matrix<double, term_count, 1>;
  std::map<std::string, std::vector<const Example*>> by_category;
  std::size_t count = 0;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    if (pairs_[i].category == key.first || examples[i].terms.rows() == 0 || has(pairs_[i].shapes, key.second)) continue;
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

// The pairs of a category share a total weight equal to its number of shapes.
template <typename Examples, typename Weights>
Weights Role_fit::fitted_of(const Key& key, std::string Unseen_pair::*group, const Examples& examples,
                            const Weights& expected, const Weights& penalties) const
{
  if (!by_category_ || key.first.empty()) return expected;
  constexpr int term_count = Weights::RowsAtCompileTime;
  std::vector<const typename Examples::value_type*> of_category;
  std::set<std::size_t> seen;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    const Shape_pair& pair = pairs_[i].shapes;
    if (pairs_[i].*group != key.first || examples[i].terms.rows() == 0 || has(pair, key.second)) continue;
    of_category.push_back(&examples[i]);
    seen.insert(pair.begin(), pair.end());
  }
  std::vector<Weighted<term_count>> chosen;
  for (const auto* example : of_category)
    chosen.push_back({example, double(seen.size()) / double(of_category.size())});
  return fitted_weights<term_count>(chosen, expected, penalties);
}

template <typename Set>
void Role_fit::for_each_key(const Set& set)
{
  std::vector<std::pair<const Key, Match_weights>*> all;
  for (auto& entry : weights_)
    all.push_back(&entry);
  for_each_index(all.size(), true, [&](std::size_t i) { set(all[i]->first, all[i]->second); });
}

inline Role_fit::Role_fit(const std::vector<Unseen_pair>& pairs, const std::vector<Part_matching>& geometric,
                          const std::vector<std::size_t>& sources, const Part_matching_options& options,
                          bool by_category)
    : pairs_(pairs),
      sources_(sources),
      by_category_(by_category),
      terms_(pairs.size()),
      confidences_(pairs.size()),
      geometric_confidences_(pairs.size())
{
  weights_[{"", {}}];
  for (const Unseen_pair& pair : pairs)
    for (const std::string& category : {pair.category, pair.nearest})
      for (const Sources& left_out : {Sources(), sources_of(pair.shapes)})
        weights_[{category, left_out}];
  const auto with_geometry = [&](const Pair_terms& terms, std::size_t i) {
    return with_geometric_terms(terms, geometric[i].costs, geometric[i].pairs);
  };
  for_each_index(pairs.size(), true, [&](std::size_t i) {
    if (pairs[i].own_terms.rows() > 0)
      terms_[i] = judged_terms(with_geometry(pairs[i].own_terms, i), pairs[i].truth, geometric[i].costs.cols());
  });
  for_each_key([&](const Key& key, Match_weights& result) {
    result.weights = fitted_of(key, &Unseen_pair::category, terms_, Pair_weights(fitted_without(key, terms_)),
                               Pair_weights(Pair_weights::Constant(category_penalty)));
  });
  for_each_index(pairs.size(), true, [&](std::size_t i) {
    const Unseen_pair& pair = pairs[i];
    geometric_confidences_[i] = judged_confidences(geometric[i].pairs, pair.truth);
    if (pair.found != pair.category) return;
    const Pair_weights& by = weights(pair.category, sources_of(pair.shapes)).weights;
    confidences_[i] = judged_confidences(
        match_by_terms(with_geometry(pair.found_terms, i), by, geometric[i], {}, options).pairs, pair.truth);
  });
  for_each_key([&](const Key& key, Match_weights& result) {
    const Confidence_weights usual = fitted_without(key, confidences_),
                             geometric_usual = fitted_without(key, geometric_confidences_);
    const Confidence_weights penalties = Confidence_weights::Constant(confidence_penalty);
    result.confidence = fitted_of(key, &Unseen_pair::category, confidences_, usual, penalties);
    result.geometric_confidence =
        fitted_of(key, &Unseen_pair::nearest, geometric_confidences_, geometric_usual, penalties);
  });
}

inline const Match_weights& Role_fit::weights(const std::string& category, const Sources& left_out) const
{
  const auto found = weights_.find({category, left_out});
  return found != weights_.end() ? found->second : weights_.at({"", {}});
}

inline void Role_fit::apply(Role_model_data& model) const
{
  for (Category_roles& category : model.categories)
    static_cast<Match_weights&>(category) = weights(category.name, {});
  model.geometric_confidence = weights("", {}).geometric_confidence;
}

} // namespace CGAL::Shape_correspondence::experiments

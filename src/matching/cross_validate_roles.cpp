// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "matching/cross_validate_roles.h"
#include "base/for_each_index.h"
#include "matching/Role_trainer.h"
#include "matching/Shape_roles.h"
#include "matching/aligned_matching.h"

#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cstdint>
#include <map>
#include <memory>
#include <numeric>
#include <random>
#include <set>
#include <utility>
#include <variant>

namespace CGAL::Shape_correspondence::internal {

namespace {

constexpr std::size_t least_pairs = 50; // of shapes, that weights are fitted to: with fewer, chance decides
constexpr double slight_charge = 1e-4;  // for large weights, where every category weighs 1: keeps them finite
// For weights of a category that are not those of the others: as strong as one shape. Set by cross-validation, where it
// is flat.
constexpr double charge_of_category = 1;

bool is_in(const Validation_pair& pair, std::size_t shape) { return shape == pair[0] || shape == pair[1]; }

// Leaves of the shapes at most so many, drawn by the number of the pair.
void draw(std::vector<std::size_t>& shapes, std::size_t count, std::uint64_t pair)
{
  std::mt19937_64 random(pair); // the same numbers on all machines
  for (std::size_t i = 0; i < shapes.size(); ++i)
    std::swap(shapes[i], shapes[i + std::size_t(random() % (shapes.size() - i))]);
  if (shapes.size() > count) shapes.resize(count);
}

std::vector<char> left_out_shapes(const std::vector<Validation_shape>& shapes, const Validation_pair& pair,
                                  std::size_t number_of_pair, const Validation_options& options)
{
  std::vector<char> result(shapes.size(), 0);
  std::vector<std::size_t> examples;
  for (std::size_t shape = 0; shape < shapes.size(); ++shape) {
    const bool same_category = shapes[shape].labelled.category == shapes[pair[0]].labelled.category;
    const bool same_source = options.left_out == Left_out::SOURCES && (shapes[shape].source == shapes[pair[0]].source ||
                                                                       shapes[shape].source == shapes[pair[1]].source);
    const bool is_example = same_category && !shapes[shape].is_generated && !same_source && !is_in(pair, shape);
    if (is_example) examples.push_back(shape);
    result[shape] = is_in(pair, shape) || same_source || (options.left_out == Left_out::CATEGORY && same_category) ||
                    (options.examples && is_example);
  }
  if (!options.examples) return result;
  draw(examples, *options.examples, number_of_pair);
  for (std::size_t shape : examples)
    result[shape] = 0;
  return result;
}

std::vector<std::size_t> indices_of(const Eigen::MatrixXi& votes)
{
  std::vector<std::size_t> result(std::size_t(votes.rows()));
  std::iota(result.begin(), result.end(), std::size_t(0));
  return result;
}

Pair_terms role_terms(const Role_votes& source, const Role_votes& target)
{
  return role_terms(source, indices_of(source.roles), target, indices_of(target.roles));
}

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

// The graph turned about the up axis, as if its meshes had been.
Structural_graph turned(Structural_graph graph, double angle)
{
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, Point::UnitY()).toRotationMatrix();
  Shape_structure& shape = structure(graph);
  for (Part_abstraction& part : shape.parts) {
    part.surface = (turn * part.surface).eval();
    std::visit([&](auto& geometry) { geometry.points = (turn * geometry.points).eval(); }, part.geometry);
  }
  shape.frame.axes = turn * shape.frame.axes;
  shape.frame.origin = turn * shape.frame.origin;
  for (std::size_t group = 0; group < num_vertices(graph); ++group) {
    Symmetry& symmetry = graph[group].symmetry;
    symmetry.point = (turn * symmetry.point).eval();
    symmetry.direction = (turn * symmetry.direction).eval();
  }
  return graph;
}

// What the matcher finds of shapes that were turned.
struct Turned_match
{
  std::vector<Part_correspondence> without_roles, with_roles;
  std::string category;
};

// The share of the target's parts that get their coarse label from the source.
double transferred_share(const Part_matching& matching, const Validation_shape& source, const Validation_shape& target)
{
  const std::vector<Part_label>&from = source.labelled.labels, &to = target.labelled.labels;
  std::size_t right = 0;
  for (std::size_t j = 0; j < to.size(); ++j)
    right += from[likeliest_source(matching, j).source].coarse == to[j].coarse;
  return double(right) / double(to.size());
}

} // namespace

// What roles tell of a pair of shapes that the training did not see.
struct Role_validation::Pair_evidence
{
  Ground_truth truth;
  std::size_t target_size = 0;
  Pair_terms told;      // of roles, with the category told; empty if the training saw nothing of it
  std::string category; // as the matcher finds it; empty: none
  Pair_terms found;     // of roles, in that one
  Front_count fronts;   // with the category told
  // Of least energy, without and with roles; by index in the structural graphs
  std::array<std::vector<Part_correspondence>, 2> least_energy;
};

namespace {

// The pairs of least energy. \param role_costs empty: without roles
std::vector<Part_correspondence> pairs_of_least_energy(const Labelled_graph& source, const Labelled_graph& target,
                                                       double role_weight, Eigen::MatrixXd role_costs)
{
  Search_options options;
  options.method = Search_method::EXACT;
  options.matching.weights.roles = role_weight;
  options.matching.role_costs = std::move(role_costs);
  return find_correspondence(*source.graph, *target.graph, options).pairs;
}

} // namespace

class Role_validation::Pair_validator
{
public:
  Pair_validator(const std::vector<Validation_shape>& shapes, const std::vector<Labelled_graph>& labelled,
                 const Role_training_options& options)
      : shapes_(shapes), trainer_(labelled, options), all_(trainer_.model()), turned_(shapes.size())
  {}

  const Role_model_data& model() const { return all_; }

  std::vector<Pair_evidence> run(const std::vector<Validation_pair>& pairs, const Validation_options& options)
  {
    for (const Validation_pair& pair : pairs)
      for (std::size_t end : pair)
        for (int turn = int(turned_[end].size()); turn < 4; ++turn)
          turned_[end].push_back(role_evidence(*shapes_[end].labelled.graph, turn));
    std::vector<Pair_evidence> result(pairs.size());
    for_each_index(pairs.size(), true, [&](std::size_t i) { result[i] = evidence(pairs[i], i, options); });
    return result;
  }

  // Both shapes turned by angles that are drawn by the number of the pair. \param weights, confidence of the category
  Turned_match turned_match(const Validation_pair& pair, std::size_t number, const Validation_options& options,
                            const Part_matching_options& parts, const Pair_weights& weights,
                            const Confidence_weights& confidence) const
  {
    auto [told, data] = left_out_model(pair, number, options);
    for (Category_roles& category : data.categories) {
      category.weights = weights;
      category.confidence = confidence;
    }
    std::mt19937_64 random(number); // the same numbers on all machines
    const auto any = [&](std::size_t shape) {
      const double angle = 2 * double(EIGEN_PI) * double(random() >> 11) / double(1ull << 53);
      return turned(*shapes_[shape].labelled.graph, angle);
    };
    const Structural_graph source = any(pair[0]), target = any(pair[1]);
    Search_options search;
    search.alignments = 0;
    search.parts = parts;
    Turned_match result;
    result.without_roles = find_correspondence(source, target, search).pairs;
    if (options.category_is_told && told < data.categories.size()) search.category = data.categories[told].name;
    search.roles = std::make_shared<const Role_model>(std::move(data));
    const Correspondence found = find_correspondence(source, target, search);
    result.with_roles = found.pairs;
    result.category = found.category;
    return result;
  }

private:
  // What the training teaches without what is left out for a pair; the pair's category is the first result.
  std::pair<std::size_t, Role_model_data> left_out_model(const Validation_pair& pair, std::size_t number,
                                                         const Validation_options& options) const
  {
    Role_model_data data = all_;
    const std::string& category = shapes_[pair[0]].labelled.category;
    const std::size_t own = data.index(category);
    data.categories[own] = trainer_.category(category, left_out_shapes(shapes_, pair, number, options));
    if (data.categories[own].roles.empty()) data.categories.erase(data.categories.begin() + std::ptrdiff_t(own));
    return {data.index(category), std::move(data)};
  }

  Turned_roles turned_roles(std::size_t shape, const Role_model& model) const
  {
    Turned_roles result;
    for (std::size_t turn = 0; turn < result.size(); ++turn)
      result[turn] = std::make_shared<Shape_roles>(turned_[shape][turn], model);
    return result;
  }

  Pair_evidence evidence(const Validation_pair& pair, std::size_t number, const Validation_options& options) const
  {
    const Labelled_graph &source = shapes_[pair[0]].labelled, &target = shapes_[pair[1]].labelled;
    auto [told, data] = left_out_model(pair, number, options);
    const Role_model model(std::move(data));
    const Turned_roles a = turned_roles(pair[0], model), b = turned_roles(pair[1], model);
    const std::size_t none = model.data().categories.size(),
                      category = options.category_is_told ? told : category_of_pair(*a[0], *b[0], model.data()).index;
    Pair_evidence result;
    result.truth = ground_truth(source.labels, target.labels);
    result.target_size = target.labels.size();
    const auto terms = [&](std::size_t of_category) {
      return role_terms(a[0]->votes(of_category), b[0]->votes(of_category));
    };
    if (told < none) {
      result.told = terms(told);
      for (const Turned_roles* shape : {&a, &b})
        count_front(front_turns(*shape, told, model.data().trees), result.fronts);
    }
    if (options.role_weight > 0)
      for (std::size_t with : {0u, 1u}) {
        Eigen::MatrixXd role_costs;
        if (with == 1 && category < none)
          role_costs = 1 - agreement_of_votes(a[0]->votes(category), b[0]->votes(category)).array();
        result.least_energy[with] = pairs_of_least_energy(source, target, options.role_weight, std::move(role_costs));
      }
    if (category == none) return result;
    result.category = model.data().categories[category].name;
    result.found = category == told ? result.told : terms(category);
    return result;
  }

  static void count_front(const std::vector<int>& turns, Front_count& fronts)
  {
    const bool is_possible = turns.front() == 0;
    ++fronts.shapes;
    fronts.possible += is_possible;
    fronts.sure += is_possible && turns.size() == 1;
  }

  const std::vector<Validation_shape>& shapes_;
  Role_trainer trainer_;
  Role_model_data all_;
  std::vector<std::vector<Role_evidence>> turned_; // by shape, by quarter turns; of those that are in a pair
};

namespace {

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
  match({});
}

Role_validation::~Role_validation() = default;

void Role_validation::match(const Part_matching_options& parts)
{
  const std::vector<Pair_evidence>& seen = with_others_.empty() ? evidence_ : with_others_;
  const auto category_of = [&](std::size_t i) { return shapes_[pairs_[i].shapes[0]].labelled.category; };
  const auto shapes_of = [&](std::size_t i) {
    return std::vector<std::size_t>(pairs_[i].shapes.begin(), pairs_[i].shapes.end());
  };
  std::vector<Part_matching> geometric(pairs_.size());
  examples_.assign(pairs_.size(), {});
  for_each_index(pairs_.size(), true, [&](std::size_t i) {
    const auto& [source, target] = pairs_[i].shapes;
    geometric[i] = geometric_match(*shapes_[source].labelled.graph, *shapes_[target].labelled.graph, parts);
    if (seen[i].told.rows() > 0)
      examples_[i] = judged_terms(with_geometric_terms(seen[i].told, geometric[i]), seen[i].truth, seen[i].target_size);
  });

  std::map<std::string, Pair_weights> of_others;
  for (std::size_t i = 0; i < pairs_.size(); ++i)
    if (of_others.count(category_of(i)) == 0) of_others[category_of(i)] = weights_without(category_of(i));
  std::vector<Pair_weights> own_weights(pairs_.size());
  confidences_.assign(pairs_.size(), {});
  geometric_confidences_.assign(pairs_.size(), {});
  for_each_index(pairs_.size(), true, [&](std::size_t i) {
    own_weights[i] = of_others.at(category_of(i));
    if (!options_.examples) own_weights[i] = weights_of(category_of(i), own_weights[i], shapes_of(i));
    if (seen[i].category.empty()) geometric_confidences_[i] = judged_confidences(geometric[i], seen[i].truth);
    if (seen[i].category != category_of(i)) return;
    const Pair_terms terms = with_geometric_terms(seen[i].found, geometric[i]);
    confidences_[i] = judged_confidences(match_by_terms(terms, own_weights[i], geometric[i], {}, parts), seen[i].truth);
  });
  std::map<std::string, Confidence_weights> confidence_of_others, geometric_confidence;
  for (const auto& [category, weights] : of_others) {
    confidence_of_others[category] = confidence_without(category, confidences_);
    geometric_confidence[category] = confidence_without(category, geometric_confidences_);
  }

  for_each_index(pairs_.size(), true, [&](std::size_t i) {
    const std::string category = category_of(i);
    const Pair_evidence& pair = evidence_[i];
    Validated_pair& result = pairs_[i];
    Pair_weights weights = of_others.at(category);
    Confidence_weights stated = confidence_of_others.at(category);
    if (pair.told.rows() > 0 && (pair.category == category || options_.is_turned)) {
      weights = own_weights[i];
      if (!options_.examples) stated = confidence_of(category, stated, shapes_of(i));
    }
    Part_matching matched = geometric[i];
    std::vector<Part_correspondence> without = geometric[i].pairs;
    result.category = pair.category;
    if (options_.is_turned) {
      Turned_match found = validator_->turned_match(result.shapes, i, options_, parts, weights, stated);
      without = std::move(found.without_roles);
      matched.pairs = std::move(found.with_roles);
      result.category = std::move(found.category);
    } else if (!pair.category.empty()) {
      matched = match_by_terms(with_geometric_terms(pair.found, geometric[i]), weights, geometric[i], {}, parts);
      state_confidences(stated, matched);
    } else {
      state_confidences(geometric_confidence.at(category), matched);
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
    result.judged = judged(matched.pairs, pair.truth);
  });
}

Pair_weights Role_validation::weights() const { return weights_without(""); }

Role_model Role_validation::model() const
{
  Role_model_data result = validator_->model();
  for (Category_roles& category : result.categories) {
    category.weights = weights_of(category.name, weights_without(category.name), {});
    category.confidence = confidence_of(category.name, confidence_without(category.name, confidences_), {});
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
    const std::string& category = shapes_[pairs_[i].shapes[0]].labelled.category;
    if (category == left_out || examples[i].terms.rows() == 0) continue;
    by_category[category].push_back(&examples[i]);
    ++count;
  }
  std::vector<Weighted<term_count>> chosen;
  for (const auto& [category, of_category] : by_category)
    for (const Example* example : of_category)
      chosen.push_back({example, 1 / double(of_category.size())});
  return Fit<Weights>{fitted_weights<term_count>(chosen, Weights::Zero(), slight_charge), count};
}

// Every shape weighs 1.
template <typename Examples, typename Weights>
Weights Role_validation::fitted_of(const std::string& category, const Examples& examples, const Weights& expected,
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
    if (shapes_[pair[0]].labelled.category != category || examples[i].terms.rows() == 0 || is_left_out(pair[0]) ||
        is_left_out(pair[1]))
      continue;
    of_category.push_back(&examples[i]);
    seen.insert(pair.begin(), pair.end());
  }
  std::vector<Weighted<term_count>> chosen;
  for (const auto* example : of_category)
    chosen.push_back({example, double(seen.size()) / double(of_category.size())});
  return fitted_weights<term_count>(chosen, expected, charge_of_category);
}

Pair_weights Role_validation::weights_without(const std::string& left_out) const
{
  const auto [weights, pairs] = fitted_without(left_out, examples_);
  return pairs < least_pairs ? usual_pair_weights() : weights;
}

Pair_weights Role_validation::weights_of(const std::string& category, const Pair_weights& expected,
                                         const std::vector<std::size_t>& left_out) const
{
  return fitted_of(category, examples_, expected, left_out);
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
  return fitted_of(category, confidences_, expected, left_out);
}

} // namespace CGAL::Shape_correspondence::internal

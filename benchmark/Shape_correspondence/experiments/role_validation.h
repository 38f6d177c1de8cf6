// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Pairs of labelled shapes matched with roles that were learned without them.
#ifndef CGAL_SHAPE_CORRESPONDENCE_EXPERIMENTS_ROLE_VALIDATION_H
#define CGAL_SHAPE_CORRESPONDENCE_EXPERIMENTS_ROLE_VALIDATION_H

#include "base/for_each_index.h"
#include "matching/aligned_matching.h"
#include "role_fit.h"

#include <CGAL/Shape_correspondence/evaluate_correspondence.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {
namespace experiments {

using namespace internal;

struct Validation_shape
{
  Labelled_graph labelled;
  std::string source; ///< where it is from
  bool is_generated = false;
};

/// What the training does not see of a pair's category.
enum class Left_out {
  SHAPES,  ///< the two shapes
  SOURCES, ///< all shapes of their sources
  CATEGORY ///< all of it
};

/// How shapes are turned about the up axis, each by an angle drawn for the pair.
enum class Validation_turns { NONE, QUARTERS, ANY };

/// As `match --front` has it.
enum class Validation_fronts { GIVEN, LIKELY, AUTO };

struct Validation_options
{
  Left_out left_out = Left_out::SHAPES;
  /// How many shapes of the category that are not generated the training sees at most, drawn for every pair; with
  /// `Left_out::CATEGORY` it sees these of all the category.
  std::optional<std::size_t> examples;
  bool category_known = false; ///< to the matcher
  Validation_turns turns = Validation_turns::NONE;
  /// What the matcher does about fronts. Where it finds them, the confidences of pairs are of what it finds.
  Validation_fronts fronts = Validation_fronts::GIVEN;
  /// Not 0: the correspondences of least energy are compared, without roles and with roles of this weight in the
  /// energy.
  double role_weight = 0;

  bool orients_shapes() const { return turns != Validation_turns::NONE || fronts != Validation_fronts::GIVEN; }
};

/// A pair of parts that was matched.
struct Judged_pair
{
  double confidence;
  bool is_right, has_one_role; ///< the pair is in the ground truth; the coarse labels are equal
};

/// How many shapes have their front among those that roles leave possible, and as the only one.
struct Front_count
{
  int shapes = 0, possible = 0, sure = 0;
};

struct Validated_pair
{
  Shape_pair shapes{};
  std::string category;                   ///< as the matcher finds it; empty: none
  Correspondence_score geometric, joined; ///< by geometry alone, and as the matcher does it
  /// The share of the target's parts that get their coarse label from the source.
  double labels_by_geometry = 0, labels_joined = 0;
  Front_count fronts;              ///< of the two shapes, with the category known
  std::vector<Judged_pair> judged; ///< of the matcher's pairs; none of least energy, which have no confidence
};

/// The graph turned about the up axis, as if its meshes had been.
inline Structural_graph turned(Structural_graph graph, double angle)
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

/// Matches of pairs of shapes that the training did not see. The weights of the terms, and of confidences, follow from
/// pairs of other categories and from those of their own category that share no shape with the one at hand; where
/// examples are limited, from pairs of other categories that were matched with as few.
class Role_validation
{
public:
  /// Keeps the shapes by reference.
  Role_validation(const std::vector<Validation_shape>& shapes, const std::vector<Shape_pair>& pairs,
                  const Validation_options& options, const Role_training_options& training)
      : shapes_(shapes),
        options_(options),
        labelled_(labelled_graphs(shapes)),
        trainer_(labelled_, training),
        all_(trainer_.model()),
        turned_(shapes.size()),
        least_energy_(pairs.size()),
        pairs_(pairs.size())
  {
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      pairs_[i].shapes = pairs[i];
      for (std::size_t shape : pairs[i])
        for (int turn = int(turned_[shape].size()); turn < 4; ++turn)
          turned_[shape].push_back(role_evidence(*labelled_[shape].graph, turn));
    }
    unseen_ = predicted(options_, true);
    // What was learned with much left out tells nothing of how good what is learned of others is
    fitted_to_ = options.left_out != Left_out::SHAPES && !options.examples ? predicted({}, false) : unseen_;
    match({});
  }

  /// Matches the pairs again by other options. What roles predict stays as it is.
  void match(const Part_matching_options& parts)
  {
    std::vector<Part_matching> geometric(pairs_.size());
    for_each_index(pairs_.size(), true, [&](std::size_t i) {
      const auto& [source, target] = pairs_[i].shapes;
      geometric[i] = geometric_match(*labelled_[source].graph, *labelled_[target].graph, parts);
    });
    fit_ = std::make_unique<Role_fit>(fitted_to_, geometric, parts, !options_.examples);
    for_each_index(pairs_.size(), true, [&](std::size_t i) { match(i, geometric[i], parts); });
  }

  const std::vector<Validated_pair>& pairs() const { return pairs_; }

  /// Fitted to all pairs; the usual ones where they are few.
  Pair_weights weights() const { return fit_->of_others("").weights; }

  /// The model that is learned from all shapes, with the weights that are fitted to the pairs.
  Role_model fitted_model() const
  {
    Role_model_data result = all_;
    fit_->apply(result);
    return Role_model_access::model(std::move(result));
  }

private:
  using Pairs = std::vector<Part_correspondence>;

  static std::vector<Labelled_graph> labelled_graphs(const std::vector<Validation_shape>& shapes)
  {
    std::vector<Labelled_graph> result;
    for (const Validation_shape& shape : shapes)
      result.push_back(shape.labelled);
    return result;
  }

  bool is_of_same_source(std::size_t shape, const Shape_pair& pair) const
  {
    return shapes_[shape].source == shapes_[pair[0]].source || shapes_[shape].source == shapes_[pair[1]].source;
  }

  /// The shapes of the category of a pair that may be examples, in an order drawn by its number.
  std::vector<std::size_t> drawn_examples(std::size_t number, Left_out left_out) const
  {
    const Shape_pair& pair = pairs_[number].shapes;
    std::vector<std::size_t> result;
    for (std::size_t shape = 0; shape < shapes_.size(); ++shape)
      if (labelled_[shape].category == labelled_[pair[0]].category && !shapes_[shape].is_generated &&
          shape != pair[0] && shape != pair[1] && !(left_out == Left_out::SOURCES && is_of_same_source(shape, pair)))
        result.push_back(shape);
    std::mt19937_64 random(number); // the same numbers on all machines
    for (std::size_t i = 0; i < result.size(); ++i)
      std::swap(result[i], result[i + std::size_t(random() % (result.size() - i))]);
    return result;
  }

  /// What the training does not see for a pair.
  std::vector<char> left_out_shapes(std::size_t number, const Validation_options& options) const
  {
    const Shape_pair& pair = pairs_[number].shapes;
    std::vector<char> result(shapes_.size(), 0);
    for (std::size_t shape = 0; shape < shapes_.size(); ++shape)
      result[shape] =
          shape == pair[0] || shape == pair[1] ||
          (options.left_out == Left_out::SOURCES && is_of_same_source(shape, pair)) ||
          (options.left_out == Left_out::CATEGORY && labelled_[shape].category == labelled_[pair[0]].category);
    if (!options.examples) return result;
    const std::vector<std::size_t> examples = drawn_examples(number, options.left_out);
    for (std::size_t i = 0; i < examples.size(); ++i)
      result[examples[i]] = i >= *options.examples;
    return result;
  }

  Role_model_data left_out_model(std::size_t number, const Validation_options& options) const
  {
    return trainer_.model_without(all_, labelled_[pairs_[number].shapes[0]].category, left_out_shapes(number, options));
  }

  /// What roles predict for all pairs. \param is_reported also counts fronts and searches for least energies
  std::vector<Unseen_pair> predicted(const Validation_options& options, bool is_reported)
  {
    std::vector<Unseen_pair> result(pairs_.size());
    for_each_index(pairs_.size(), true, [&](std::size_t i) {
      const Shape_pair& pair = pairs_[i].shapes;
      const Role_model_data data = left_out_model(i, options);
      const Role_model model = Role_model_access::model(data);
      std::array<Turned_roles, 2> roles;
      for (std::size_t end : {0u, 1u})
        for (std::size_t turn = 0; turn < 4; ++turn)
          roles[end][turn] = std::make_shared<Shape_roles>(turned_[pair[end]][turn], model);
      result[i] = unseen_pair(labelled_, pair, *roles[0][0], *roles[1][0], data, options.category_known);
      const std::size_t own = data.index(labelled_[pair[0]].category), found = data.index(result[i].found);
      if (!is_reported) return;
      for (const Turned_roles& shape : roles)
        if (own < data.categories.size()) count_front(front_turns(shape, own, data.trees), pairs_[i].fronts);
      if (options.role_weight == 0) return;
      least_energy_[i][0] = of_least_energy(pair, {});
      Eigen::MatrixXd costs;
      if (found < data.categories.size())
        costs = 1 - agreement_of_votes(roles[0][0]->votes(found), roles[1][0]->votes(found)).array();
      least_energy_[i][1] = of_least_energy(pair, std::move(costs));
    });
    return result;
  }

  static void count_front(const std::vector<int>& turns, Front_count& fronts)
  {
    const bool is_possible = turns.front() == 0;
    ++fronts.shapes;
    fronts.possible += is_possible;
    fronts.sure += is_possible && turns.size() == 1;
  }

  /// \param role_costs empty: without roles
  Pairs of_least_energy(const Shape_pair& pair, Eigen::MatrixXd role_costs) const
  {
    Search_options options;
    options.method = Search_method::EXACT;
    options.matching.weights.roles = options_.role_weight;
    options.matching.role_costs = std::move(role_costs);
    return find_correspondence(*labelled_[pair[0]].graph, *labelled_[pair[1]].graph, options).pairs;
  }

  void match(std::size_t i, const Part_matching& geometric, const Part_matching_options& parts)
  {
    Validated_pair& result = pairs_[i];
    const auto& [source, target] = result.shapes;
    const Unseen_pair& pair = unseen_[i];
    const std::vector<std::size_t> shapes{source, target};
    Part_matching matched = geometric;
    Pairs without = geometric.pairs;
    result.category = pair.found;
    Match_weights weights = fit_->of_others(pair.category);
    if (pair.own_terms.rows() > 0 && (pair.found == pair.category || options_.orients_shapes()))
      weights = {fit_->weights_of_pair(i), fit_->confidence(pair.category, shapes), weights.geometric_confidence};
    if (options_.orients_shapes()) {
      match_turned(i, parts, weights, without, matched.pairs);
    } else if (!pair.found.empty()) {
      const Pair_terms terms = with_geometric_terms(pair.found_terms, geometric.costs, geometric.pairs);
      matched = match_by_terms(terms, weights.weights, geometric, {}, parts);
      state_confidences(weights.confidence, matched);
    } else {
      const bool sees_category = options_.left_out != Left_out::CATEGORY;
      state_confidences(
          fit_->geometric_confidence(pair.nearest, pair.category, sees_category ? shapes : shapes_of(pair.category)),
          matched);
    }
    if (options_.role_weight > 0) {
      without = least_energy_[i][0];
      matched.pairs = least_energy_[i][1];
    }
    result.geometric = evaluate_correspondence(part_pairs(without), pair.truth);
    result.joined = evaluate_correspondence(part_pairs(matched.pairs), pair.truth);
    result.labels_by_geometry = transferred_share(geometric, source, target);
    result.labels_joined = transferred_share(matched, source, target);
    result.judged.clear();
    const auto has = [](const Part_pairs& known, const Part_correspondence& found) {
      return std::binary_search(known.begin(), known.end(), std::make_pair(found.source, found.target));
    };
    for (const Part_correspondence& found : matched.pairs)
      if (options_.role_weight == 0)
        result.judged.push_back({found.confidence, has(pair.truth.pairs, found), has(pair.truth.coarse_pairs, found)});
  }

  /// Both shapes turned by angles that are drawn by the number of the pair.
  void match_turned(std::size_t number, const Part_matching_options& parts, const Match_weights& weights,
                    Pairs& without, Pairs& with_roles)
  {
    Validated_pair& result = pairs_[number];
    Role_model_data data = left_out_model(number, options_);
    for (Category_roles& category : data.categories) {
      category.weights = weights.weights;
      category.confidence = weights.confidence;
    }
    std::mt19937_64 random(number); // the same numbers on all machines
    const auto any = [&](std::size_t shape) {
      const double share = double(random() >> 11) / double(1ull << 53);
      const double turns = options_.turns == Validation_turns::ANY ? share : std::floor(4 * share) / 4;
      const Structural_graph& graph = *labelled_[shape].graph;
      return options_.turns == Validation_turns::NONE ? graph : turned(graph, 2 * double(EIGEN_PI) * turns);
    };
    const Structural_graph source = any(result.shapes[0]), target = any(result.shapes[1]);
    Search_options search;
    search.alignments = options_.fronts == Validation_fronts::AUTO ? 0 : 1;
    search.front_is_sure = options_.fronts == Validation_fronts::GIVEN;
    search.parts = parts;
    without = find_correspondence(source, target, search).pairs;
    const std::string& own = labelled_[result.shapes[0]].category;
    if (options_.category_known && data.index(own) < data.categories.size()) search.category = own;
    search.roles = std::make_shared<const Role_model>(Role_model_access::model(std::move(data)));
    const Correspondence found = find_correspondence(source, target, search);
    with_roles = found.pairs;
    result.category = found.category;
  }

  std::vector<std::size_t> shapes_of(const std::string& category) const
  {
    std::vector<std::size_t> result;
    for (std::size_t shape = 0; shape < labelled_.size(); ++shape)
      if (labelled_[shape].category == category) result.push_back(shape);
    return result;
  }

  /// The share of the target's parts that get their coarse label from the source.
  double transferred_share(const Part_matching& matching, std::size_t source, std::size_t target) const
  {
    const std::vector<Part_label>&from = labelled_[source].labels, &to = labelled_[target].labels;
    std::size_t right = 0;
    for (std::size_t j = 0; j < to.size(); ++j)
      right += from[likeliest_source(matching, j).source].coarse == to[j].coarse;
    return double(right) / double(to.size());
  }

  const std::vector<Validation_shape>& shapes_;
  Validation_options options_;
  std::vector<Labelled_graph> labelled_; // the same shapes
  Role_trainer trainer_;
  Role_model_data all_;                            // learned from all shapes
  std::vector<std::vector<Role_evidence>> turned_; // by shape, by quarter turns; of those that are in a pair
  std::vector<Unseen_pair> unseen_, fitted_to_;    // by pair; the latter with no more left out than its shapes
  std::vector<std::array<Pairs, 2>> least_energy_; // by pair; without and with roles
  std::vector<Validated_pair> pairs_;
  std::unique_ptr<Role_fit> fit_;
};

} // namespace experiments
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_EXPERIMENTS_ROLE_VALIDATION_H

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

// Matches pairs of labelled shapes with roles that were learned without them.
#pragma once

#include "base/for_each_index.h"
#include "matching/aligned_matching.h"
#include "role_fit.h"

#include <CGAL/Shape_correspondence/evaluate_correspondence.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL::Shape_correspondence::experiments {

using namespace internal;

struct Validation_shape
{
  Labelled_graph labelled;
  std::string source; ///< name of its origin, such as a pack or an artist
};

/// Shapes of a pair's category that are left out of the training of its roles.
enum class Left_out {
  SHAPES,  ///< the two shapes of the pair
  SOURCES, ///< all shapes from the source of either shape of the pair
  CATEGORY ///< all shapes of the category
};

/// Turns of shapes about the up axis by random angles: none, by multiples of 90°, or by any angle.
enum class Validation_turns { NONE, QUARTERS, ANY };

/// Which fronts of shapes the matcher takes; the values of the option `--front` of the command `match`.
enum class Validation_fronts { GIVEN, LIKELY, AUTO };

struct Validation_options
{
  Left_out left_out = Left_out::SHAPES;
  /// Largest number of real shapes of the pair's category that the training sees, drawn for each pair; no value: no
  /// limit. With `Left_out::CATEGORY`, the training sees no other shapes of the category.
  std::optional<std::size_t> examples;
  bool with_generated = true;  ///< whether the training sees generated shapes
  bool category_known = false; ///< whether the category is given to the matcher
  Validation_turns turns = Validation_turns::NONE;
  /// Unless `GIVEN`, confidences are those of the match with the fronts found.
  Validation_fronts fronts = Validation_fronts::GIVEN;
  /// Weight of roles in the energy. If it is not 0, the correspondences of least energy without and with roles are
  /// compared, instead of matches by parts.
  double role_weight = 0;

  bool orients_shapes() const { return turns != Validation_turns::NONE || fronts != Validation_fronts::GIVEN; }
};

/// A matched pair of parts, judged by the labels.
struct Judged_pair
{
  double confidence;
  bool is_right, has_one_role; ///< whether it is in the ground truth; whether coarse labels are equal
};

/// Numbers of shapes: all; those whose true front fits the roles of their parts; those of them where no other does.
struct Front_count
{
  int shapes = 0, possible = 0, sure = 0;
};

struct Validated_pair
{
  Shape_pair shapes{};
  std::string category;                   ///< category that the matcher finds; empty: none
  Correspondence_score geometric, joined; ///< of the match without roles, and with roles
  /// Share of the target's parts that take the right coarse label from a source part; without and with roles.
  double labels_by_geometry = 0, labels_joined = 0;
  std::array<double, 2> distances{}; ///< distances of the pair from the two nearest categories
  Front_count fronts;                ///< of the two shapes, by the roles of their category
  std::vector<Judged_pair> judged;   ///< matched pairs; none if energies are compared or the category is left out
};

/// The graph of the shape turned about the up axis by `angle`, in radians.
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

/// Matches pairs of shapes with roles learned without them. The weights of terms and confidences for a pair are fitted
/// to pairs that share no source with it. The roles of the latter are learned from neither their own sources nor
/// generated shapes; if examples are limited, only pairs of other categories are used, with equally few examples. A
/// pair is matched by geometry alone if the pairs of its category that share no source with it gain nothing from roles.
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
        pairs_(pairs.size()),
        with_roles_(pairs.size())
  {
    number_sources();
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      pairs_[i].shapes = pairs[i];
      for (std::size_t shape : pairs[i])
        for (int turn = int(turned_[shape].size()); turn < 4; ++turn)
          turned_[shape].push_back(role_evidence(*labelled_[shape].graph, turn));
    }
    if (!options.examples) {
      Validation_options of_fit;
      of_fit.left_out = options.left_out == Left_out::SHAPES ? Left_out::SHAPES : Left_out::SOURCES;
      of_fit.with_generated = false;
      fitted_to_ = predicted(of_fit, false);
    }
    unseen_ = predicted(options_, true); // the last prediction, since `match_turned()` uses `learned_`
    if (options.examples) fitted_to_ = unseen_;
    match({});
  }

  /// Matches all pairs again with other options and the same roles.
  void match(const Part_matching_options& parts)
  {
    std::vector<Part_matching> geometric(pairs_.size());
    for_each_index(pairs_.size(), true, [&](std::size_t i) {
      const auto& [source, target] = pairs_[i].shapes;
      geometric[i] = geometric_match(*labelled_[source].graph, *labelled_[target].graph, parts);
    });
    fit_ = std::make_unique<Role_fit>(fitted_to_, geometric, sources_, parts, !options_.examples);
    for_each_index(pairs_.size(), true, [&](std::size_t i) { match(i, geometric[i], parts, true); });
    if (options_.role_weight > 0 || options_.orients_shapes()) return;
    std::vector<std::size_t> by_geometry;
    for (std::size_t i = 0; i < pairs_.size(); ++i)
      if (!pairs_[i].category.empty() && gain(pairs_[i].category, fit_->sources_of(pairs_[i].shapes)) <= 0)
        by_geometry.push_back(i);
    gains_.clear();
    for_each_index(by_geometry.size(), true,
                   [&](std::size_t i) { match(by_geometry[i], geometric[by_geometry[i]], parts, false); });
  }

  const std::vector<Validated_pair>& pairs() const { return pairs_; }

  /// The weights of terms, fitted to all pairs; the usual weights if there are fewer than `least_pairs`.
  Pair_weights weights() const { return fit_->weights("", {}).weights; }

  /// The model learned from all shapes, with weights fitted to all pairs.
  Role_model fitted_model() const
  {
    Role_model_data result = all_;
    fit_->apply(result);
    for (Category_roles& category : result.categories)
      if (gain(category.name, {}) <= 0) category.weights.head<GEOMETRIC_PAIR>().setZero();
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

  // Numbers the sources of shapes, such as packs and artists; with `Left_out::SHAPES`, each shape is its own source.
  void number_sources()
  {
    std::map<std::string, std::size_t> numbers;
    for (std::size_t shape = 0; shape < shapes_.size(); ++shape)
      sources_.push_back(options_.left_out == Left_out::SHAPES
                             ? shape
                             : numbers.emplace(shapes_[shape].source, numbers.size()).first->second);
  }

  bool is_of_same_source(std::size_t shape, const Shape_pair& pair) const
  {
    return sources_[shape] == sources_[pair[0]] || sources_[shape] == sources_[pair[1]];
  }

  // Mean gain of F1 by roles over the pairs of a category without shapes of these sources; 1 if there is no such pair.
  double gain(const std::string& category, const Sources& left_out) const
  {
    const auto known = gains_.find({category, left_out});
    if (known != gains_.end()) return known->second;
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < pairs_.size(); ++i)
      if (unseen_[i].category == category && !fit_->has(pairs_[i].shapes, left_out)) {
        sum += with_roles_[i] - pairs_[i].geometric.f1();
        ++count;
      }
    return gains_[{category, left_out}] = count > 0 ? sum / double(count) : 1;
  }

  /// The real shapes of a pair's category that the training may see, in random order. \param number index of the pair
  std::vector<std::size_t> drawn_examples(std::size_t number, Left_out left_out) const
  {
    const Shape_pair& pair = pairs_[number].shapes;
    std::vector<std::size_t> result;
    for (std::size_t shape = 0; shape < shapes_.size(); ++shape)
      if (labelled_[shape].category == labelled_[pair[0]].category && !labelled_[shape].is_generated &&
          shape != pair[0] && shape != pair[1] && !(left_out == Left_out::SOURCES && is_of_same_source(shape, pair)))
        result.push_back(shape);
    std::mt19937_64 random(number); // gives the same numbers on all machines
    for (std::size_t i = 0; i < result.size(); ++i)
      std::swap(result[i], result[i + std::size_t(random() % (result.size() - i))]);
    return result;
  }

  /// For every shape, whether it is left out of the training for a pair. \param number index of the pair
  std::vector<char> left_out_shapes(std::size_t number, const Validation_options& options) const
  {
    const Shape_pair& pair = pairs_[number].shapes;
    std::vector<char> result(shapes_.size(), 0);
    for (std::size_t shape = 0; shape < shapes_.size(); ++shape)
      result[shape] =
          (!options.with_generated && labelled_[shape].is_generated) || shape == pair[0] || shape == pair[1] ||
          (options.left_out == Left_out::SOURCES && is_of_same_source(shape, pair)) ||
          (options.left_out == Left_out::CATEGORY && labelled_[shape].category == labelled_[pair[0]].category);
    if (!options.examples) return result;
    const std::vector<std::size_t> examples = drawn_examples(number, options.left_out);
    for (std::size_t i = 0; i < examples.size(); ++i)
      result[examples[i]] = i >= *options.examples;
    return result;
  }

  /// A category, and the indices of its shapes that are left out of the training.
  using Left_out_of_category = std::pair<std::string, std::vector<std::size_t>>;

  std::vector<Left_out_of_category> left_out_by_category(const std::vector<char>& is_left_out) const
  {
    std::map<std::string, std::vector<std::size_t>> result;
    for (std::size_t shape = 0; shape < shapes_.size(); ++shape)
      if (is_left_out[shape]) result[labelled_[shape].category].push_back(shape);
    return {result.begin(), result.end()};
  }

  /// Learns the roles of every category without each set of shapes that is left out for some pair.
  void learn(const Validation_options& options)
  {
    std::map<Left_out_of_category, Category_roles> learned;
    for (std::size_t i = 0; i < pairs_.size(); ++i)
      for (Left_out_of_category& left_out : left_out_by_category(left_out_shapes(i, options)))
        learned[std::move(left_out)];
    std::vector<std::pair<const Left_out_of_category, Category_roles>*> all;
    for (auto& entry : learned)
      all.push_back(&entry);
    for_each_index(all.size(), true, [&](std::size_t i) {
      std::vector<char> is_left_out(shapes_.size(), 0);
      for (std::size_t shape : all[i]->first.second)
        is_left_out[shape] = 1;
      all[i]->second = trainer_.category(all[i]->first.first, is_left_out);
    });
    learned_ = std::move(learned);
  }

  /// The model learned without the shapes that are left out for a pair.
  Role_model_data left_out_model(std::size_t number, const Validation_options& options) const
  {
    Role_model_data result = all_;
    for (const Left_out_of_category& left_out : left_out_by_category(left_out_shapes(number, options)))
      result.categories[result.index(left_out.first)] = learned_.at(left_out);
    const auto is_empty = [](const Category_roles& category) { return category.roles.empty(); };
    result.categories.erase(std::remove_if(result.categories.begin(), result.categories.end(), is_empty),
                            result.categories.end());
    return result;
  }

  /// Predictions by roles for all pairs. \param is_reported whether to count fronts and search least energies, too
  std::vector<Unseen_pair> predicted(const Validation_options& options, bool is_reported)
  {
    std::vector<Unseen_pair> result(pairs_.size());
    learn(options);
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

  /// The pairs of parts of least energy. \param role_costs by source and target part; empty: without roles
  Pairs of_least_energy(const Shape_pair& pair, Eigen::MatrixXd role_costs) const
  {
    Search_options options;
    options.method = Search_method::EXACT;
    options.energy.weights.roles = options_.role_weight;
    options.energy.role_costs = std::move(role_costs);
    return find_correspondence(*labelled_[pair[0]].graph, *labelled_[pair[1]].graph, options).pairs;
  }

  void match(std::size_t i, const Part_matching& geometric, const Part_matching_options& parts, bool by_roles)
  {
    Validated_pair& result = pairs_[i];
    const auto& [source, target] = result.shapes;
    const Unseen_pair& pair = unseen_[i];
    const Sources sources = fit_->sources_of(result.shapes);
    Part_matching matched = geometric;
    Pairs without = geometric.pairs;
    result.category = pair.found;
    const bool has_weights = pair.own_terms.rows() > 0 && (pair.found == pair.category || options_.orients_shapes());
    const Match_weights& weights = has_weights ? fit_->weights(pair.category, sources) : fit_->weights("", {});
    if (options_.orients_shapes()) {
      match_turned(i, parts, weights, without, matched.pairs);
    } else if (!pair.found.empty() && by_roles) {
      const Pair_terms terms = with_geometric_terms(pair.found_terms, geometric.costs, geometric.pairs);
      matched = match_by_terms(terms, weights.weights, geometric, {}, parts);
      state_confidences(weights.confidence, matched);
    } else {
      state_confidences(fit_->weights(pair.nearest, sources).geometric_confidence, matched);
    }
    if (options_.role_weight > 0) {
      without = least_energy_[i][0];
      matched.pairs = least_energy_[i][1];
    }
    result.geometric = evaluate_correspondence(part_pairs(without), pair.truth);
    result.joined = evaluate_correspondence(part_pairs(matched.pairs), pair.truth);
    result.distances = pair.distances;
    if (by_roles) with_roles_[i] = result.joined.f1();
    result.labels_by_geometry = transferred_share(geometric, source, target);
    result.labels_joined = transferred_share(matched, source, target);
    result.judged.clear();
    const auto has = [](const Part_pairs& known, const Part_correspondence& found) {
      return std::binary_search(known.begin(), known.end(), std::make_pair(found.source, found.target));
    };
    for (const Part_correspondence& found : matched.pairs)
      if (options_.role_weight == 0 && options_.left_out != Left_out::CATEGORY)
        result.judged.push_back({found.confidence, has(pair.truth.pairs, found), has(pair.truth.coarse_pairs, found)});
  }

  /// Matches a pair whose shapes are turned by random angles, without and with roles. \param number index of the pair
  void match_turned(std::size_t number, const Part_matching_options& parts, const Match_weights& weights,
                    Pairs& without, Pairs& with_roles)
  {
    Validated_pair& result = pairs_[number];
    Role_model_data data = left_out_model(number, options_);
    for (Category_roles& category : data.categories) {
      category.weights = weights.weights;
      category.confidence = weights.confidence;
    }
    std::mt19937_64 random(number); // gives the same numbers on all machines
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

  /// Share of the target's parts whose coarse label is that of their likeliest source part.
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
  std::vector<Labelled_graph> labelled_; // of `shapes_`
  Role_trainer trainer_;
  Role_model_data all_;                            // model learned from all shapes
  std::vector<std::vector<Role_evidence>> turned_; // by shape and quarter turns of it; empty for shapes in no pair
  std::vector<Unseen_pair> unseen_, fitted_to_;    // predictions by pair: to report; to fit weights to
  std::vector<std::array<Pairs, 2>> least_energy_; // by pair of shapes: pairs of parts without, with roles
  std::vector<Validated_pair> pairs_;
  std::unique_ptr<Role_fit> fit_;
  std::vector<std::size_t> sources_;                       // number of the source, by shape
  std::map<Left_out_of_category, Category_roles> learned_; // roles of the last prediction
  std::vector<double> with_roles_;                         // F1 by pair, if roles are used
  mutable std::map<std::pair<std::string, Sources>, double> gains_;
};

} // namespace CGAL::Shape_correspondence::experiments

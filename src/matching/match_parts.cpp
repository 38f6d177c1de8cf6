// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "matching/match_parts.h"
#include "base/Disjoint_sets.h"
#include "base/quantized.h"
#include "matching/Part_costs.h"
#include "roles/pair_model.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace CGAL::Shape_correspondence {
using namespace internal;

namespace {

void check(const Part_matching_options& options)
{
  const Part_cost_weights& w = options.weights;
  for (double value : {w.overlap, w.extent, w.ground, w.place, w.orientation, w.chamfer, w.features, options.whole,
                       options.excess, options.confident_excess, options.main_surface, options.side_depth,
                       options.wall_width, options.category_ratio, options.category_distance, options.clearly_better})
    if (!(value >= 0) || !std::isfinite(value))
      throw Invalid_input("match_parts: the weights and bounds of costs must be finite and not negative");
  if (w.features > largest_feature_weight)
    throw Invalid_input("match_parts: the weight of features must be at most 1000");
  if (options.clearly_better >= 1)
    throw Invalid_input("match_parts: the share by which a front or an alignment is better must be less than 1");
  if (options.repetition < 2) throw Invalid_input("match_parts: a regular arrangement needs two parts or more");
  for (double value : {options.tolerance, options.anchor, options.warp_width})
    if (!(value > 0) || !std::isfinite(value))
      throw Invalid_input("match_parts: the tolerance, the anchor and the width of warps must be finite and above 0");
}

using Match_matrix = Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic>;

// Parts of both shapes that correspond as sets: a block in the matrix of matches.
struct Block
{
  std::vector<std::size_t> source, target;
};

std::vector<Block> blocks_of(const Match_matrix& confident, const Shape_features& source, const Shape_features& target)
{
  const std::size_t n = source.size(), all = n + target.size();
  Disjoint_sets sets(all);
  const auto join_panels = [&](const Shape_features& features, std::size_t first) {
    for (const std::vector<std::size_t>& panel : features.assemblies.panels)
      for (std::size_t part : panel)
        sets.unite(first + panel[0], first + part);
  };
  join_panels(source, 0);
  join_panels(target, n);
  for (Eigen::Index i = 0; i < confident.rows(); ++i)
    for (Eigen::Index j = 0; j < confident.cols(); ++j)
      if (confident(i, j)) sets.unite(std::size_t(i), n + std::size_t(j));

  std::vector<Block> by_first(all), result;
  for (std::size_t k = 0; k < all; ++k) {
    Block& block = by_first[sets[k]];
    k < n ? block.source.push_back(k) : block.target.push_back(k - n);
  }
  for (Block& block : by_first)
    if (!block.source.empty() && !block.target.empty()) result.push_back(std::move(block));
  return result;
}

// The pairs that are the best of one of their parts, and exceed the least costs of both by at most `excess` in sum.
Match_matrix pairs_within(const Eigen::MatrixXd& costs, double excess)
{
  const Eigen::VectorXd least_in_row = costs.rowwise().minCoeff(), least_in_column = costs.colwise().minCoeff();
  const Steps most = quantized(excess);
  Match_matrix result(costs.rows(), costs.cols());
  for (Eigen::Index j = 0; j < costs.cols(); ++j)
    for (Eigen::Index i = 0; i < costs.rows(); ++i) {
      const Steps over_row = quantized(costs(i, j) - least_in_row[i]);
      const Steps over_column = quantized(costs(i, j) - least_in_column[j]);
      result(i, j) = (over_row == 0 || over_column == 0) && over_row + over_column <= most;
    }
  return result;
}

// Pairs coincident copies of a part one to one, in their order, if both shapes have equally many, since all their pairs
// cost the same. Levels of detail and collision meshes are such copies.
void separate_copies(const Eigen::MatrixXd& costs, double tolerance, Match_matrix& pairs)
{
  const Eigen::VectorXd least_in_row = costs.rowwise().minCoeff(), least_in_column = costs.colwise().minCoeff();
  const auto are_tied = [&](Eigen::Index i, Eigen::Index j) {
    return pairs(i, j) && quantized(costs(i, j)) <= quantized(tolerance) &&
           quantized(costs(i, j) - least_in_row[i]) == 0 && quantized(costs(i, j) - least_in_column[j]) == 0;
  };
  const Eigen::Index n = costs.rows(), m = costs.cols();
  Disjoint_sets sets(std::size_t(n + m));
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < m; ++j)
      if (are_tied(i, j)) sets.unite(std::size_t(i), std::size_t(n + j));
  if (sets.number_of_sets() == sets.size()) return;
  std::map<std::size_t, std::array<std::vector<Eigen::Index>, 2>> copies; // for each set, the parts of either shape
  for (Eigen::Index k = 0; k < n + m; ++k)
    copies[sets[std::size_t(k)]][k < n ? 0 : 1].push_back(k < n ? k : k - n);
  for (const auto& [set, of_shape] : copies) {
    const auto& [rows, columns] = of_shape;
    bool are_copies = rows.size() == columns.size() && rows.size() > 1;
    for (std::size_t k = 0; are_copies && k < rows.size(); ++k)
      are_copies = are_tied(rows[k], columns[k]);
    for (std::size_t a = 0; are_copies && a < rows.size(); ++a)
      for (std::size_t b = 0; b < columns.size(); ++b)
        pairs(rows[a], columns[b]) = a == b;
  }
}

// For each row, the number of its pairs with the columns.
std::vector<std::size_t> number_of_pairs(const Match_matrix& pairs, const std::vector<std::size_t>& rows,
                                         const std::vector<std::size_t>& columns)
{
  std::vector<std::size_t> result;
  for (std::size_t i : rows)
    result.push_back(std::size_t(std::count_if(
        columns.begin(), columns.end(), [&](std::size_t j) { return pairs(Eigen::Index(i), Eigen::Index(j)); })));
  return result;
}

bool are_all(const std::vector<std::size_t>& counts, std::size_t count)
{
  return std::all_of(counts.begin(), counts.end(), [&](std::size_t c) { return c == count; });
}

// Whether the parts of a block pair one to one, at costs of at most `tolerance`.
bool are_same_parts(const Block& block, const Match_matrix& confident, const Eigen::MatrixXd& costs,
                    const Part_matching_options& options)
{
  if (!are_all(number_of_pairs(confident, block.source, block.target), 1) ||
      !are_all(number_of_pairs(confident.transpose(), block.target, block.source), 1))
    return false;
  for (std::size_t i : block.source)
    for (std::size_t j : block.target)
      if (confident(Eigen::Index(i), Eigen::Index(j)) &&
          quantized(costs(Eigen::Index(i), Eigen::Index(j))) > quantized(options.tolerance))
        return false;
  return true;
}

std::vector<char> flags(const std::vector<std::size_t>& parts, std::size_t count)
{
  std::vector<char> result(count, 0);
  for (std::size_t part : parts)
    result[part] = 1;
  return result;
}

std::vector<char> is_in_panel(const Shape_features& features)
{
  std::vector<std::size_t> parts;
  for (const std::vector<std::size_t>& panel : features.assemblies.panels)
    parts.insert(parts.end(), panel.begin(), panel.end());
  return flags(parts, features.size());
}

void match_all(const std::vector<std::size_t>& source, const std::vector<std::size_t>& target, Match_matrix& pairs)
{
  for (std::size_t i : source)
    for (std::size_t j : target)
      pairs(Eigen::Index(i), Eigen::Index(j)) = true;
}

// Adds all pairs of a block if its numbers of parts of both shapes differ, or its panels do not pair one to one.
void complete_blocks(const std::vector<Block>& blocks, const Match_matrix& confident, const Eigen::MatrixXd& costs,
                     const Shape_features& source, const Shape_features& target, const Part_matching_options& options,
                     Match_matrix& pairs)
{
  const std::vector<char> source_panels = is_in_panel(source), target_panels = is_in_panel(target);
  const auto has_panel = [](const std::vector<std::size_t>& parts, const std::vector<char>& is_in_panel) {
    return std::any_of(parts.begin(), parts.end(), [&](std::size_t part) { return bool(is_in_panel[part]); });
  };
  for (const Block& block : blocks)
    if (block.source.size() != block.target.size() ||
        ((has_panel(block.source, source_panels) || has_panel(block.target, target_panels)) &&
         !are_same_parts(block, confident, costs, options)))
      match_all(block.source, block.target, pairs);
}

// Whether every leg of the shape with fewer legs has a counterpart of its own, and all other legs stand on the ground.
bool supports_pair_one_to_one(const Match_matrix& confident, const Part_assemblies& fewer, const Part_assemblies& more)
{
  const std::vector<std::size_t> of_fewer = number_of_pairs(confident, fewer.legs, more.legs),
                                 of_more = number_of_pairs(confident.transpose(), more.legs, fewer.legs);
  if (!are_all(of_fewer, 1)) return false;
  for (std::size_t k = 0; k < of_more.size(); ++k)
    if (of_more[k] > 1 || (of_more[k] == 0 && !more.is_on_ground[more.legs[k]])) return false;
  return true;
}

// Whether the supports of two shapes correspond as sets, every leg to every leg.
bool support_as_sets(const Match_matrix& confident, const Part_assemblies& a, const Part_assemblies& b)
{
  if (a.support.empty() || b.support.empty()) return false;
  return !(a.legs.size() <= b.legs.size() ? supports_pair_one_to_one(confident, a, b)
                                          : supports_pair_one_to_one(confident.transpose(), b, a));
}

// Removes the pairs of a leg with a part outside of the other shape's support.
void separate_supports(const Shape_features& source, const Shape_features& target, Match_matrix& pairs)
{
  const std::vector<char> a = flags(source.assemblies.support, source.size()),
                          b = flags(target.assemblies.support, target.size());
  for (std::size_t i : source.assemblies.legs)
    for (std::size_t j = 0; j < target.size(); ++j)
      if (!b[j]) pairs(Eigen::Index(i), Eigen::Index(j)) = false;
  for (std::size_t j : target.assemblies.legs)
    for (std::size_t i = 0; i < source.size(); ++i)
      if (!a[i]) pairs(Eigen::Index(i), Eigen::Index(j)) = false;
}

Match_matrix matched(const Eigen::MatrixXd& costs, const Shape_features& source, const Shape_features& target,
                     const Part_matching_options& options)
{
  Match_matrix confident = pairs_within(costs, options.confident_excess), pairs = pairs_within(costs, options.excess);
  separate_copies(costs, options.tolerance, confident);
  separate_copies(costs, options.tolerance, pairs);
  complete_blocks(blocks_of(confident, source, target), confident, costs, source, target, options, pairs);
  if (support_as_sets(confident, source.assemblies, target.assemblies)) {
    separate_supports(source, target, pairs);
    match_all(source.assemblies.legs, target.assemblies.legs, pairs);
  }
  return pairs;
}

// The shape reflected in a horizontal plane, which keeps left and right, front and back.
Aligned_shape turned_over(Aligned_shape shape)
{
  for (Sampled_part& part : shape.parts)
    part.surface.row(1) *= -1;
  return shape;
}

// For each pair, the least cost of the other pairs of its two parts that were not taken, minus its own cost.
Eigen::MatrixXd margins(const Eigen::MatrixXd& costs, const Match_matrix& pairs)
{
  const Eigen::MatrixXd others = pairs.select(
      Eigen::MatrixXd::Constant(costs.rows(), costs.cols(), std::numeric_limits<double>::infinity()), costs);
  const Eigen::VectorXd of_source = others.rowwise().minCoeff(), of_target = others.colwise().minCoeff();
  return of_source.replicate(1, costs.cols()).cwiseMin(of_target.transpose().replicate(costs.rows(), 1)) - costs;
}

// Logistic function of the margin. Pairs of blocks with negative margins are right as often as those of margin 0.
double confidence(double margin) { return std::min(1 / (1 + std::exp(-std::max(0., margin))), 1 - least_doubt); }

// Cost of a pair that is forbidden; greater than all other costs.
constexpr double forbidden_cost = 1e4;

Eigen::MatrixXd costs_of(const Shape_features& a, const Shape_features& b, const Part_matching_options& options,
                         const Match_constraints& constraints, const Deadline* deadline)
{
  Eigen::MatrixXd costs = part_costs(a, b, options, deadline);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j)
      if (!constraints.allows(i, j)) costs(Eigen::Index(i), Eigen::Index(j)) = forbidden_cost;
  return costs;
}

Part_matching matching_of(Eigen::MatrixXd costs, const Shape_features& source, const Shape_features& target,
                          const Part_matching_options& options, const Match_constraints& constraints)
{
  const Match_matrix pairs = matched(costs, source, target, options);
  const Eigen::MatrixXd margin = margins(costs, pairs);
  Part_matching result;
  for (Eigen::Index i = 0; i < pairs.rows(); ++i)
    for (Eigen::Index j = 0; j < pairs.cols(); ++j)
      if (pairs(i, j)) result.pairs.push_back({std::size_t(i), std::size_t(j), confidence(margin(i, j))});
  result.costs = std::move(costs);
  constrain(constraints, result);
  return result;
}

} // namespace

void constrain(const Match_constraints& constraints, Part_matching& matching)
{
  if (constraints.empty()) return;
  std::vector<Part_correspondence>& pairs = matching.pairs;
  pairs.erase(std::remove_if(pairs.begin(), pairs.end(),
                             [&](const Part_correspondence& pair) {
                               return !constraints.allows(pair.source, pair.target) ||
                                      !constraints.pinned(pair.source).empty();
                             }),
              pairs.end());
  for (std::size_t i = 0; i < std::size_t(matching.costs.rows()); ++i)
    for (std::size_t j : constraints.pinned(i))
      pairs.push_back({i, j, 1});
  std::sort(pairs.begin(), pairs.end(), is_before);
}

Part_matching match_parts(const Aligned_shape& source, const Aligned_shape& target,
                          const Part_matching_options& options, const Match_constraints& constraints)
{
  check(options);
  return match_parts(Shape_features(source, options), Shape_features(target, options), options, constraints);
}

Part_matching match_parts(const Shape_features& a, const Shape_features& b, const Part_matching_options& options,
                          const Match_constraints& constraints, const Deadline* deadline)
{
  check(options);
  if (a.assemblies.has_chain() == b.assemblies.has_chain()) {
    Part_matching result = matching_of(costs_of(a, b, options, constraints, deadline), a, b, options, constraints);
    result.evidence = evidence_of_features(a, b, options);
    return result;
  }

  // A shape with a chain hangs from it: of the two shapes, the one is turned over for which the costs are lower
  const Aligned_shape source_over = turned_over(a.shape), target_over = turned_over(b.shape);
  const Shape_features a_over(source_over, options), b_over(target_over, options);
  Eigen::MatrixXd target_turned = costs_of(a, b_over, options, constraints, deadline),
                  source_turned = costs_of(a_over, b, options, constraints, deadline);
  const Steps over_target = quantized(mean_least_cost(target_turned)),
              over_source = quantized(mean_least_cost(source_turned));
  const bool turn_source = over_source < over_target || (over_source == over_target && a.rank < b.rank);
  Part_matching result = turn_source ? matching_of(std::move(source_turned), a_over, b, options, constraints)
                                     : matching_of(std::move(target_turned), a, b_over, options, constraints);
  result.upside_down = true;
  result.evidence = evidence_of_features(a, b, options);
  return result;
}

} // namespace CGAL::Shape_correspondence

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_INTERNAL_MATCH_PARTS_IMPL_H
#define CGAL_SHAPE_CORRESPONDENCE_INTERNAL_MATCH_PARTS_IMPL_H

#include <CGAL/Shape_correspondence/match_parts.h>

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/internal/Part_costs_impl.h>
#include <CGAL/Shape_correspondence/internal/quantized.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

using Match_matrix = Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic>;

// Logistic model of how often a pair is right by the margin of its cost, set on the development set.
constexpr double confidence_offset = 0.1, confidence_slope = 0.5, largest_margin = 3;

inline void check(const Part_matching_options& options)
{
  const Part_cost_weights& w = options.weights;
  for (double value : {w.overlap, w.extent, w.ground, w.side, w.front, w.orientation, w.chamfer, options.excess,
                       options.sure_excess, options.sibling})
    if (!(value >= 0) || !std::isfinite(value))
      throw Invalid_input("match_parts: the weights and bounds of costs must be finite and not negative");
}

// Pairs that cost least for one of their parts and, over both, at most so much more than least.
inline Match_matrix pairs_within(const Eigen::MatrixXd& costs, double excess)
{
  const Eigen::VectorXd least_in_row = costs.rowwise().minCoeff(), least_in_column = costs.colwise().minCoeff();
  Match_matrix result(costs.rows(), costs.cols());
  for (Eigen::Index i = 0; i < costs.rows(); ++i)
    for (Eigen::Index j = 0; j < costs.cols(); ++j) {
      const long over_row = quantized(costs(i, j) - least_in_row[i]);
      const long over_column = quantized(costs(i, j) - least_in_column[j]);
      result(i, j) = (over_row == 0 || over_column == 0) && over_row + over_column <= quantized(excess);
    }
  return result;
}

// Parts of either shape that stand for one another as a whole.
struct Block
{
  std::vector<std::size_t> source, target;

  bool is_lone() const { return source.empty() || target.empty(); }
};

// Groups of three or more stay together, as do parts in a pair.
inline std::vector<Block> blocks_of(const Match_matrix& pairs, const Aligned_shape& source, const Aligned_shape& target)
{
  const std::size_t n = source.parts.size(), all = n + target.parts.size();
  std::vector<std::size_t> parent(all);
  std::iota(parent.begin(), parent.end(), std::size_t(0));
  const auto root = [&](std::size_t k) {
    while (parent[k] != k)
      k = parent[k] = parent[parent[k]];
    return k;
  };
  const auto join = [&](std::size_t k, std::size_t l) {
    const std::size_t a = root(k), b = root(l);
    parent[std::max(a, b)] = std::min(a, b);
  };
  const auto join_groups = [&](const Aligned_shape& shape, std::size_t first) {
    for (const Aligned_shape::Group& group : shape.groups)
      if (group.parts.size() >= whole_group_size)
        for (std::size_t part : group.parts)
          join(first + group.parts[0], first + part);
  };
  join_groups(source, 0);
  join_groups(target, n);
  for (Eigen::Index i = 0; i < pairs.rows(); ++i)
    for (Eigen::Index j = 0; j < pairs.cols(); ++j)
      if (pairs(i, j)) join(std::size_t(i), n + std::size_t(j));

  std::vector<Block> by_root(all), result;
  for (std::size_t k = 0; k < all; ++k) {
    Block& block = by_root[root(k)];
    k < n ? block.source.push_back(k) : block.target.push_back(k - n);
  }
  for (Block& block : by_root)
    if (!block.source.empty() || !block.target.empty()) result.push_back(std::move(block));
  return result;
}

inline void append(std::vector<std::size_t>& to, const std::vector<std::size_t>& from)
{
  to.insert(to.end(), from.begin(), from.end());
}

// What the parts of lone blocks cost among each other and with the others of their shape, which is all that joining
// looks at: one of two blocks that are joined is lone.
inline Eigen::MatrixXd costs_of_lone_parts(const std::vector<Block>& blocks, std::vector<std::size_t> Block::*side,
                                           const Aligned_shape& shape, const Part_cost_weights& weights)
{
  std::vector<char> is_lone(shape.parts.size(), 0);
  bool has_lone = false;
  for (const Block& block : blocks)
    if (block.is_lone())
      for (std::size_t part : block.*side)
        is_lone[part] = has_lone = true;
  return has_lone ? own_part_costs(shape, is_lone, weights) : Eigen::MatrixXd();
}

// Lone blocks join what they resemble in their own shape, the most alike first.
class Lone_block_joiner
{
public:
  Lone_block_joiner(std::vector<Block> blocks, Eigen::MatrixXd source_costs, Eigen::MatrixXd target_costs)
      : blocks_(std::move(blocks)),
        source_costs_(std::move(source_costs)),
        target_costs_(std::move(target_costs)),
        costs_(blocks_.size(), std::vector<long>(blocks_.size(), never))
  {
    for (std::size_t k = 0; k < blocks_.size(); ++k)
      for (std::size_t l = 0; l < k; ++l)
        costs_[k][l] = joining_cost(blocks_[k], blocks_[l]);
  }

  std::vector<Block> run(double bound)
  {
    while (join_cheapest(quantized(bound))) {
    }
    return std::move(blocks_);
  }

private:
  static constexpr long never = std::numeric_limits<long>::max();

  long joining_cost(const Block& a, const Block& b) const
  {
    if (!a.is_lone() && !b.is_lone()) return never;
    if (!a.source.empty() && !b.source.empty()) return quantized(set_cost(source_costs_, a.source, b.source));
    if (!a.target.empty() && !b.target.empty()) return quantized(set_cost(target_costs_, a.target, b.target));
    return never;
  }

  bool join_cheapest(long bound)
  {
    std::size_t best_k = 0, best_l = 0;
    for (std::size_t k = 0; k < blocks_.size(); ++k)
      for (std::size_t l = 0; l < k; ++l)
        if (costs_[k][l] < bound) bound = costs_[k][l], best_k = k, best_l = l;
    if (best_k == best_l) return false;

    append(blocks_[best_l].source, blocks_[best_k].source);
    append(blocks_[best_l].target, blocks_[best_k].target);
    blocks_[best_k] = {};
    for (std::size_t k = 0; k < blocks_.size(); ++k) {
      if (k != best_l) costs_[std::max(k, best_l)][std::min(k, best_l)] = joining_cost(blocks_[k], blocks_[best_l]);
      if (k != best_k) costs_[std::max(k, best_k)][std::min(k, best_k)] = never;
    }
    return true;
  }

  std::vector<Block> blocks_; // empty where joined to another one
  Eigen::MatrixXd source_costs_, target_costs_;
  std::vector<std::vector<long>> costs_; // [k][l] for l < k
};

// Every part of a block with every other where they differ in number.
inline void fill_blocks(const std::vector<Block>& blocks, Match_matrix& pairs)
{
  for (const Block& block : blocks)
    if (block.source.size() != block.target.size())
      for (std::size_t i : block.source)
        for (std::size_t j : block.target)
          pairs(Eigen::Index(i), Eigen::Index(j)) = true;
}

// By how much the best pair that was not taken costs more, of either part.
inline double margin(const Eigen::MatrixXd& costs, const Match_matrix& pairs, Eigen::Index i, Eigen::Index j)
{
  double alternative = std::numeric_limits<double>::infinity();
  for (Eigen::Index k = 0; k < costs.cols(); ++k)
    if (!pairs(i, k)) alternative = std::min(alternative, costs(i, k));
  for (Eigen::Index k = 0; k < costs.rows(); ++k)
    if (!pairs(k, j)) alternative = std::min(alternative, costs(k, j));
  return std::clamp(alternative - costs(i, j), -largest_margin, largest_margin);
}

inline double confidence(double margin) { return 1 / (1 + std::exp(-(confidence_offset + confidence_slope * margin))); }

} // namespace internal

CGAL_SHAPE_CORRESPONDENCE_INLINE Part_matching match_parts(const Aligned_shape& source, const Aligned_shape& target,
                                                           const Part_matching_options& options)
{
  using namespace internal;
  check(options);
  const Eigen::MatrixXd costs = part_costs(source, target, options.weights);

  std::vector<Block> blocks = blocks_of(pairs_within(costs, options.sure_excess), source, target);
  if (std::any_of(blocks.begin(), blocks.end(), [](const Block& block) { return block.is_lone(); })) {
    Eigen::MatrixXd source_costs = costs_of_lone_parts(blocks, &Block::source, source, options.weights);
    Eigen::MatrixXd target_costs = costs_of_lone_parts(blocks, &Block::target, target, options.weights);
    blocks =
        Lone_block_joiner(std::move(blocks), std::move(source_costs), std::move(target_costs)).run(options.sibling);
  }
  Match_matrix pairs = pairs_within(costs, options.excess);
  fill_blocks(blocks, pairs);

  Part_matching result;
  for (Eigen::Index i = 0; i < costs.rows(); ++i)
    for (Eigen::Index j = 0; j < costs.cols(); ++j)
      if (pairs(i, j)) result.pairs.push_back({std::size_t(i), std::size_t(j), confidence(margin(costs, pairs, i, j))});
  result.costs = costs;
  return result;
}

} // namespace Shape_correspondence
} // namespace CGAL

#endif

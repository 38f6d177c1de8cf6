// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_MATCHING_PART_BLOCKS_H
#define CGAL_SHAPE_CORRESPONDENCE_MATCHING_PART_BLOCKS_H

#include "base/Disjoint_sets.h"
#include "base/quantized.h"
#include "matching/Assembled_shape.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

using Match_matrix = Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic>;

// Parts of either shape that stand for one another as a whole.
struct Block
{
  std::vector<std::size_t> source, target;

  bool is_lone() const { return source.empty() || target.empty(); }
};

// Groups of three or more and panels stay together, as do parts in a pair.
inline std::vector<Block> blocks_of(const Match_matrix& pairs, const Assembled_shape& source,
                                    const Assembled_shape& target)
{
  const std::size_t n = source.size(), all = n + target.size();
  Disjoint_sets sets(all);
  const auto join_all = [&](const std::vector<std::size_t>& parts, std::size_t first) {
    for (std::size_t part : parts)
      sets.unite(first + parts[0], first + part);
  };
  const auto join_wholes = [&](const Assembled_shape& assembled, std::size_t first) {
    for (const Aligned_shape::Group& group : assembled.shape.groups)
      if (group.parts.size() >= whole_group_size) join_all(group.parts, first);
    for (const std::vector<std::size_t>& panel : assembled.assemblies.panels)
      join_all(panel, first);
  };
  join_wholes(source, 0);
  join_wholes(target, n);
  for (Eigen::Index i = 0; i < pairs.rows(); ++i)
    for (Eigen::Index j = 0; j < pairs.cols(); ++j)
      if (pairs(i, j)) sets.unite(std::size_t(i), n + std::size_t(j));

  std::vector<Block> by_set(all), result;
  for (std::size_t k = 0; k < all; ++k) {
    Block& block = by_set[sets[k]];
    k < n ? block.source.push_back(k) : block.target.push_back(k - n);
  }
  for (Block& block : by_set)
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
                                           const Compared_shape& shape, const Part_cost_weights& weights)
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

// Blocks of parts that stand for one another, the sure pairs first.
inline std::vector<Block> joined_blocks(const Match_matrix& sure, const Assembled_shape& source,
                                        const Assembled_shape& target, const Part_matching_options& options)
{
  std::vector<Block> blocks = blocks_of(sure, source, target);
  if (std::none_of(blocks.begin(), blocks.end(), [](const Block& block) { return block.is_lone(); })) return blocks;
  Eigen::MatrixXd source_costs = costs_of_lone_parts(blocks, &Block::source, source.compared, options.weights);
  Eigen::MatrixXd target_costs = costs_of_lone_parts(blocks, &Block::target, target.compared, options.weights);
  return Lone_block_joiner(std::move(blocks), std::move(source_costs), std::move(target_costs)).run(options.sibling);
}

} // namespace internal
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_MATCHING_PART_BLOCKS_H

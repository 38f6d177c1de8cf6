// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "matching/part_blocks.h"
#include "base/Disjoint_sets.h"
#include "base/quantized.h"
#include "matching/Part_costs.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace CGAL::Shape_correspondence::internal {

namespace {

// Groups of three or more and panels stay together, as do parts in a pair.
std::vector<Block> blocks_of(const Match_matrix& pairs, const Shape_features& source, const Shape_features& target)
{
  const std::size_t n = source.size(), all = n + target.size();
  Disjoint_sets sets(all);
  const auto join_all = [&](const std::vector<std::size_t>& parts, std::size_t first) {
    for (std::size_t part : parts)
      sets.unite(first + parts[0], first + part);
  };
  const auto join_sets = [&](const Shape_features& features, std::size_t first) {
    for (const Part_group& group : groups(features.shape))
      if (group.parts.size() >= minimum_repetition) join_all(group.parts, first);
    for (const std::vector<std::size_t>& panel : features.assemblies.panels)
      join_all(panel, first);
  };
  join_sets(source, 0);
  join_sets(target, n);
  for (Eigen::Index i = 0; i < pairs.rows(); ++i)
    for (Eigen::Index j = 0; j < pairs.cols(); ++j)
      if (pairs(i, j)) sets.unite(std::size_t(i), n + std::size_t(j));

  std::vector<Block> by_first(all), result;
  for (std::size_t k = 0; k < all; ++k) {
    Block& block = by_first[sets[k]];
    k < n ? block.source.push_back(k) : block.target.push_back(k - n);
  }
  for (Block& block : by_first)
    if (!block.source.empty() || !block.target.empty()) result.push_back(std::move(block));
  return result;
}

void append(std::vector<std::size_t>& to, const std::vector<std::size_t>& from)
{
  to.insert(to.end(), from.begin(), from.end());
}

class One_sided_block_joiner
{
public:
  One_sided_block_joiner(std::vector<Block> blocks, const Shape_features& source, const Shape_features& target)
      : blocks_(std::move(blocks)),
        source_(source),
        target_(target),
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
    if (!a.is_one_sided() && !b.is_one_sided()) return never;
    if (!a.source.empty() && !b.source.empty()) return quantized(set_cost(source_.costs_within(), a.source, b.source));
    if (!a.target.empty() && !b.target.empty()) return quantized(set_cost(target_.costs_within(), a.target, b.target));
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
  const Shape_features &source_, &target_;
  std::vector<std::vector<long>> costs_; // [k][l] for l < k
};

} // namespace

std::vector<Block> joined_blocks(const Match_matrix& confident, const Shape_features& source,
                                 const Shape_features& target, const Part_matching_options& options)
{
  std::vector<Block> blocks = blocks_of(confident, source, target);
  if (std::none_of(blocks.begin(), blocks.end(), [](const Block& block) { return block.is_one_sided(); }))
    return blocks;
  return One_sided_block_joiner(std::move(blocks), source, target).run(options.shared_counterpart);
}

} // namespace CGAL::Shape_correspondence::internal

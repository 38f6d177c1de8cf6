// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "matching/part_blocks.h"
#include "base/Disjoint_sets.h"
#include "base/quantized.h"
#include "matching/Part_costs.h"

#include <Eigen/Core>

#include <algorithm>
#include <limits>
#include <utility>

namespace CGAL::Shape_correspondence::internal {

namespace {

// Groups of `repetition` or more and panels stay together, as do parts in a pair.
std::vector<Block> blocks_of(const Match_matrix& pairs, const Shape_features& source, const Shape_features& target,
                             std::size_t repetition)
{
  const std::size_t n = source.size(), all = n + target.size();
  Disjoint_sets sets(all);
  const auto join_all = [&](const std::vector<std::size_t>& parts, std::size_t first) {
    for (std::size_t part : parts)
      sets.unite(first + parts[0], first + part);
  };
  const auto join_sets = [&](const Shape_features& features, std::size_t first) {
    for (const Part_group& group : groups(features.shape))
      if (group.parts.size() >= repetition) join_all(group.parts, first);
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
        of_source_(source.costs_within(one_sided_parts(&Block::source))),
        of_target_(target.costs_within(one_sided_parts(&Block::target))),
        costs_(blocks_.size()),
        nearest_(blocks_.size(), 0)
  {
    for (std::size_t k = 0; k < blocks_.size(); ++k) {
      for (std::size_t l = 0; l < k; ++l)
        costs_[k].push_back(joining_cost(blocks_[k], blocks_[l]));
      find_nearest(k);
    }
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
    if (!a.is_one_sided()) return b.is_one_sided() ? joining_cost(b, a) : never;
    if (!a.source.empty() && !b.source.empty()) return quantized(set_cost(of_source_, a.source, b.source));
    if (!a.target.empty() && !b.target.empty()) return quantized(set_cost(of_target_, a.target, b.target));
    return never;
  }

  // A block that is made of others has one side only if they all have that one: these are the rows that are needed.
  std::vector<std::size_t> one_sided_parts(std::vector<std::size_t> Block::*side) const
  {
    std::vector<std::size_t> result;
    for (const Block& block : blocks_)
      if (block.is_one_sided()) append(result, block.*side);
    return result;
  }

  void find_nearest(std::size_t k)
  {
    nearest_[k] = std::size_t(std::min_element(costs_[k].begin(), costs_[k].end()) - costs_[k].begin());
  }

  bool join_cheapest(long bound)
  {
    std::size_t joined = 0;
    for (std::size_t k = 1; k < blocks_.size(); ++k)
      if (costs_[k][nearest_[k]] < bound) bound = costs_[k][nearest_[k]], joined = k;
    if (joined == 0) return false;

    const std::size_t kept = nearest_[joined];
    append(blocks_[kept].source, blocks_[joined].source);
    append(blocks_[kept].target, blocks_[joined].target);
    blocks_[joined] = {};
    std::fill(costs_[joined].begin(), costs_[joined].end(), never);
    for (std::size_t l = 0; l < kept; ++l)
      costs_[kept][l] = joining_cost(blocks_[kept], blocks_[l]);
    find_nearest(kept);
    for (std::size_t k = kept + 1; k < blocks_.size(); ++k)
      update_row(k, kept, joined);
    return true;
  }

  // After `joined` became part of `kept`, which comes before it and before k.
  void update_row(std::size_t k, std::size_t kept, std::size_t joined)
  {
    std::vector<long>& costs = costs_[k];
    const std::size_t nearest = nearest_[k];
    costs[kept] = joining_cost(blocks_[k], blocks_[kept]);
    if (joined < k) costs[joined] = never;
    if (nearest == kept || nearest == joined)
      find_nearest(k);
    else if (std::make_pair(costs[kept], kept) < std::make_pair(costs[nearest], nearest))
      nearest_[k] = kept;
  }

  std::vector<Block> blocks_;                     // empty where joined to another one
  const Eigen::MatrixXd &of_source_, &of_target_; // costs within, of the parts in one-sided blocks with all
  std::vector<std::vector<long>> costs_;          // [k][l] for l < k
  std::vector<std::size_t> nearest_;              // the first l of least cost for each k > 0
};

} // namespace

std::vector<Block> joined_blocks(const Match_matrix& confident, const Shape_features& source,
                                 const Shape_features& target, const Part_matching_options& options)
{
  std::vector<Block> blocks = blocks_of(confident, source, target, options.repetition);
  if (std::none_of(blocks.begin(), blocks.end(), [](const Block& block) { return block.is_one_sided(); }))
    return blocks;
  return One_sided_block_joiner(std::move(blocks), source, target).run(options.shared_counterpart);
}

} // namespace CGAL::Shape_correspondence::internal

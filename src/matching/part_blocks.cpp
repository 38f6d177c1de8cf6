// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "matching/part_blocks.h"
#include "base/Disjoint_sets.h"

#include <utility>

namespace CGAL::Shape_correspondence::internal {

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

} // namespace CGAL::Shape_correspondence::internal

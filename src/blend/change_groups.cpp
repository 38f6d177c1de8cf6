// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/change_groups.h"

#include "base/Disjoint_sets.h"
#include "blend/Blend_stage.h"
#include "blend/unlike_pairs.h"

#include <algorithm>
#include <utility>

namespace CGAL::Shape_correspondence::internal {

std::vector<std::size_t> change_groups(const Blend_stage& stage, const Part_pairs& unlike,
                                       const std::vector<Blend_part>& parts, const std::vector<Unmatched_chain>& chains)
{
  constexpr double inside = 0.8; // of a matched part, not on it
  Disjoint_sets sets(parts.size());
  const auto part_of = [&](int end, std::size_t given) { return parts_of(parts, end, given).front(); };
  for (const auto& [s, t] : unlike)
    sets.unite(part_of(0, s), part_of(1, t));
  std::size_t standing = Blend_task::no_part; // one that stands
  for (const Unmatched_chain& chain : chains) {
    if (chain.stands() && standing == Blend_task::no_part) standing = chain.parts[0];
    if (chain.stands()) sets.unite(chain.parts[0], standing);
    for (std::size_t part : chain.parts) {
      const std::size_t image = stage.images[std::size_t(chain.end)][parts[part].given(chain.end)];
      sets.unite(part, chain.parts[0]);
      if (image != Mirror_images::none) sets.unite(part, part_of(chain.end, image));
    }
  }
  for (const Unmatched_chain& chain : chains)
    for (std::size_t part : chain.parts) {
      double most = 0;
      std::size_t best = part;
      for (std::size_t other = 0; other < parts.size(); ++other) {
        if (!parts[other].is_at(1 - chain.end)) continue;
        const auto [s, t] = chain.end == 0 ? std::pair(part, other) : std::pair(other, part);
        const double shared = shared_place(stage, parts[s].given(0), parts[t].given(1));
        const double least = parts[other].is_matched() ? inside : same_place;
        if (shared > std::max(most, least)) most = shared, best = other;
      }
      sets.unite(part, best);
    }
  std::vector<std::size_t> result;
  for (std::size_t part = 0; part < parts.size(); ++part)
    result.push_back(sets[part]);
  return result;
}

} // namespace CGAL::Shape_correspondence::internal

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/leftover_pairs.h"

#include "base/quantized.h"
#include "blend/Blend_part.h"
#include "blend/Blend_stage.h"
#include "blend/unlike_pairs.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::internal {
namespace {

/// The box of a part in units of the box around the whole, made a little larger, as a plate has none.
contacts::Box relative_box(const Blend_stage& stage, std::size_t end, std::size_t part)
{
  constexpr double around = 0.03;
  const contacts::Box &whole = stage.boxes[end], box = box_of(stage.meshes[end][part].points);
  const Point sizes = whole.sizes().cwiseMax(2 * Part_chart::least_half_extent);
  const Point low = (box.min() - whole.min()).cwiseQuotient(sizes),
              high = (box.max() - whole.min()).cwiseQuotient(sizes);
  return {low.array() - around, high.array() + around};
}

/// The overlap of boxes over the smaller one.
double overlap(const contacts::Box& a, const contacts::Box& b)
{
  return a.intersects(b) ? a.intersection(b).volume() / std::min(a.volume(), b.volume()) : 0;
}

} // namespace

Part_pairs leftover_pairs(const Blend_stage& stage, const Part_pairs& paired, const Part_pairs& unlike)
{
  constexpr double much = 0.4;
  std::array<std::vector<char>, 2> is_used;
  for (std::size_t end : {0u, 1u})
    is_used[end].resize(stage.meshes[end].size(), 0);
  for (const Part_pairs* pairs : {&paired, &unlike})
    for (const auto& [s, t] : *pairs)
      is_used[0][s] = is_used[1][t] = 1;
  std::vector<std::pair<Steps, Part_pairs::value_type>> alike; ///< by how little they overlap
  for (std::size_t s = 0; s < is_used[0].size(); ++s)
    for (std::size_t t = 0; t < is_used[1].size(); ++t) {
      if (is_used[0][s] || is_used[1][t]) continue;
      const double shared = overlap(relative_box(stage, 0, s), relative_box(stage, 1, t));
      if (shared > much && !are_unlike(stage, s, t)) alike.emplace_back(-quantized(shared), std::pair(s, t));
    }
  std::sort(alike.begin(), alike.end());
  Part_pairs result;
  for (const auto& [cost, pair] : alike) {
    if (is_used[0][pair.first] || is_used[1][pair.second]) continue;
    is_used[0][pair.first] = is_used[1][pair.second] = 1;
    result.push_back(pair);
  }
  std::sort(result.begin(), result.end());
  return result;
}

} // namespace CGAL::Shape_correspondence::internal

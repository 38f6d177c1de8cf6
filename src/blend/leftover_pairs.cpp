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

using Used_parts = std::array<std::vector<char>, 2>; // by end

Used_parts used_parts(const Blend_stage& stage, const Part_pairs& pairs)
{
  Used_parts result = {std::vector<char>(stage.meshes[0].size(), 0), std::vector<char>(stage.meshes[1].size(), 0)};
  for (const auto& [s, t] : pairs)
    result[0][s] = result[1][t] = 1;
  return result;
}

/// The pairs of unused parts that share their place, and how much they overlap.
std::vector<std::pair<double, Part_pairs::value_type>> overlapping(const Blend_stage& stage, const Used_parts& is_used)
{
  constexpr double much = 0.4;
  std::vector<std::pair<double, Part_pairs::value_type>> result;
  for (std::size_t s = 0; s < is_used[0].size(); ++s)
    for (std::size_t t = 0; t < is_used[1].size(); ++t) {
      if (is_used[0][s] || is_used[1][t]) continue;
      const double shared = overlap(relative_box(stage, 0, s), relative_box(stage, 1, t));
      if (shared > much) result.emplace_back(shared, std::pair(s, t));
    }
  return result;
}

} // namespace

Part_pairs leftover_pairs(const Blend_stage& stage, const Part_pairs& given)
{
  Used_parts is_used = used_parts(stage, given);
  std::vector<std::pair<Steps, Part_pairs::value_type>> alike; ///< by how little they overlap
  for (const auto& [shared, pair] : overlapping(stage, is_used))
    if (!are_unlike(stage, pair.first, pair.second)) alike.emplace_back(-quantized(shared), pair);
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

Part_pairs leftover_links(const Blend_stage& stage, const Part_pairs& given)
{
  Part_pairs result;
  for (const auto& [shared, pair] : overlapping(stage, used_parts(stage, given)))
    result.push_back(pair);
  return result;
}

} // namespace CGAL::Shape_correspondence::internal

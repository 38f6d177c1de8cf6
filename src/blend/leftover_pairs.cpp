// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/leftover_pairs.h"

#include "blend/Blend_part.h"
#include "blend/Blend_stage.h"
#include "blend/unlike_pairs.h"

#include <algorithm>
#include <array>
#include <vector>

namespace CGAL::Shape_correspondence::internal {
namespace {

/// The box of a part in units of the box around the whole, made a little larger, as a plate has none.
contacts::Box relative_box(const Blend_stage& stage, std::size_t end, std::size_t part)
{
  constexpr double around = 0.03;
  const contacts::Box &whole = stage.boxes[end], box = box_of(stage.meshes[end][part].points);
  const Point sizes = whole.sizes().cwiseMax(2 * Part_chart::least_half_extent);
  const Point low = (box.min() - whole.min()).cwiseQuotient(sizes), high = (box.max() - whole.min()).cwiseQuotient(sizes);
  return {low.array() - around, high.array() + around};
}

bool are_in_one_place(const contacts::Box& a, const contacts::Box& b)
{
  constexpr double much = 0.4; // of the smaller one
  return a.intersects(b) && a.intersection(b).volume() > much * std::min(a.volume(), b.volume());
}

} // namespace

Part_pairs leftover_pairs(const Blend_stage& stage, const Part_pairs& paired, const Part_pairs& unlike)
{
  std::array<std::vector<char>, 2> is_used;
  for (std::size_t end : {0u, 1u})
    is_used[end].resize(stage.meshes[end].size(), 0);
  for (const Part_pairs* pairs : {&paired, &unlike})
    for (const auto& [s, t] : *pairs)
      is_used[0][s] = is_used[1][t] = 1;
  Part_pairs alike;
  std::array<std::vector<int>, 2> count = {std::vector<int>(is_used[0].size()), std::vector<int>(is_used[1].size())};
  for (std::size_t s = 0; s < is_used[0].size(); ++s)
    for (std::size_t t = 0; t < is_used[1].size(); ++t) {
      if (is_used[0][s] || is_used[1][t]) continue;
      if (!are_in_one_place(relative_box(stage, 0, s), relative_box(stage, 1, t)) || are_unlike(stage, s, t)) continue;
      alike.emplace_back(s, t);
      ++count[0][s];
      ++count[1][t];
    }
  const auto is_one_of_several = [&](const auto& pair) { return count[0][pair.first] > 1 || count[1][pair.second] > 1; };
  alike.erase(std::remove_if(alike.begin(), alike.end(), is_one_of_several), alike.end());
  return alike;
}

} // namespace CGAL::Shape_correspondence::internal

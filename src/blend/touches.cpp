// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/touches.h"

#include "base/quantized.h"
#include "blend/Blend_stage.h"

#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace CGAL::Shape_correspondence::internal {

std::vector<Touch> touches(const Blend_stage& stage, const std::vector<Blend_part>& parts, double tolerance)
{
  std::map<std::array<std::size_t, 2>, Touch> found; // by parts, the smaller index first
  for (int end : {0, 1})
    for (const Contact& contact : structure(stage.graphs[std::size_t(end)]).contacts) {
      const auto first = parts_of(parts, end, contact.parts[0]), second = parts_of(parts, end, contact.parts[1]);
      const bool are_whole = first.size() == 1 && second.size() == 1;
      for (std::size_t a : first)
        for (std::size_t b : second) {
          if (a == b) continue;
          const double gap = std::sqrt(parts[a].end_tree(end).nearly_closest(parts[b].end_tree(end)).squared);
          const std::array<std::size_t, 2> pair = {std::min(a, b), std::max(a, b)};
          if (are_whole || gap <= tolerance)
            found.try_emplace(pair, Touch{pair}).first->second.gaps[std::size_t(end)] = gap;
        }
    }
  std::vector<Touch> result;
  for (const auto& [pair, touch] : found)
    result.push_back(touch);
  return result;
}

std::vector<Touch> kept_holds(const std::vector<Blend_part>& parts, const std::vector<Touch>& touches)
{
  std::vector<std::pair<Steps, std::size_t>> order; // the largest first
  for (std::size_t part = 0; part < parts.size(); ++part)
    if (parts[part].is_matched()) order.emplace_back(-quantized(parts[part].size), part);
  std::sort(order.begin(), order.end());
  std::vector<std::size_t> rank(parts.size(), order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    rank[order[i].second] = i;
  std::vector<std::optional<Touch>> holds(order.size()); // by rank
  for (Touch touch : touches) {
    if (!touch.is_kept()) continue;
    if (rank[touch.parts[0]] < rank[touch.parts[1]]) std::swap(touch.parts[0], touch.parts[1]);
    std::optional<Touch>& known = holds[rank[touch.parts[0]]];
    if (!known || rank[touch.parts[1]] < rank[known->parts[1]]) known = touch;
  }
  std::vector<Touch> result;
  for (const std::optional<Touch>& hold : holds)
    if (hold) result.push_back(*hold);
  return result;
}

} // namespace CGAL::Shape_correspondence::internal

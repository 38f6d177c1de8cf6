// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/touches.h"

#include "blend/Blend_stage.h"

#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <algorithm>
#include <cmath>
#include <map>

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

} // namespace CGAL::Shape_correspondence::internal

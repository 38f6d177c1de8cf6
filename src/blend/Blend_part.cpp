// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Blend_part.h"

#include "base/quantized.h"

#include <algorithm>
#include <utility>

namespace CGAL::Shape_correspondence::internal {

void Blend_part::set_ends()
{
  for (int surface = 0; surface < number_of_surfaces(); ++surface) {
    const Points at_end = points(surface, surface);
    trees.push_back(tree_of(at_end, triangles(surface)));
    rests.emplace_back(at_end, triangles(surface));
    size = std::max(size, trees.back().box().diagonal().norm());
  }
}

std::vector<std::size_t> parts_of(const std::vector<Blend_part>& parts, int end, std::size_t given)
{
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (parts[i].given(end) == given) result.push_back(i);
  return result;
}

std::size_t nearest_piece(const std::vector<Blend_part>& parts, int end, std::size_t given, const Point& p)
{
  const std::vector<std::size_t> pieces = parts_of(parts, end, given);
  const auto distance = [&](std::size_t piece) {
    std::size_t triangle = 0;
    return quantized((parts[piece].end_tree(end).nearest(p, triangle) - p).norm());
  };
  return *std::min_element(pieces.begin(), pieces.end(),
                           [&](std::size_t a, std::size_t b) { return distance(a) < distance(b); });
}

} // namespace CGAL::Shape_correspondence::internal

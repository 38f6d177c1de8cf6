// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_INTERNAL_BLEND_WIDEST_GAP_H
#define CGAL_SHAPE_CORRESPONDENCE_INTERNAL_BLEND_WIDEST_GAP_H

#include <CGAL/Shape_correspondence/internal/map/Charted_mesh.h>

#include <limits>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

inline std::vector<contacts::Triangle_tree> trees_of(const std::vector<Part_mesh>& parts)
{
  std::vector<contacts::Triangle_tree> result;
  for (const Part_mesh& part : parts)
    result.push_back(tree_of(part.points, part.triangles));
  return result;
}

/// The longest edge of a shortest spanning tree of surfaces.
inline double widest_gap(const std::vector<contacts::Triangle_tree>& trees)
{
  std::vector<double> distance(trees.size(), std::numeric_limits<double>::infinity());
  std::vector<char> is_joined(trees.size(), 0);
  double widest = 0;
  for (std::size_t next = 0, count = 0; count < trees.size(); ++count) {
    is_joined[next] = 1;
    std::size_t nearest = next;
    for (std::size_t i = 0; i < trees.size(); ++i) {
      if (is_joined[i]) continue;
      distance[i] = std::min(distance[i], std::sqrt(trees[next].nearly_closest(trees[i]).squared));
      if (is_joined[nearest] || distance[i] < distance[nearest]) nearest = i;
    }
    if (nearest != next) widest = std::max(widest, distance[nearest]);
    next = nearest;
  }
  return widest;
}

} // namespace internal
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_INTERNAL_BLEND_WIDEST_GAP_H

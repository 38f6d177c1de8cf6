// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_BLEND_JOINING_WAYS_H
#define CGAL_SHAPE_CORRESPONDENCE_BLEND_JOINING_WAYS_H

#include "base/Disjoint_sets.h"
#include "base/quantized.h"
#include "map/Charted_mesh.h"

#include <array>
#include <cmath>
#include <functional>
#include <queue>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

/// A way from one surface to another.
struct Joining_way
{
  std::array<std::size_t, 2> surfaces;
  double length;
};

/// The shortest ways that join sets of surfaces, the shortest first. Distances are measured in the order of those of
/// the boxes, which bound them from below, until all are joined: seldom more than there are surfaces.
inline std::vector<Joining_way> joining_ways(const std::vector<const contacts::Triangle_tree*>& surfaces,
                                             Disjoint_sets sets)
{
  constexpr bool measured = false, bounded = true; // what is measured comes first
  using Candidate = std::tuple<long, bool, std::size_t, std::size_t, double>;
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<Candidate>> queue;
  for (std::size_t a = 0; a < surfaces.size(); ++a)
    for (std::size_t b = a + 1; b < surfaces.size(); ++b) {
      if (sets[a] == sets[b]) continue;
      const double bound = surfaces[a]->box().exteriorDistance(surfaces[b]->box());
      queue.emplace(quantized(bound), bounded, a, b, bound);
    }
  std::vector<Joining_way> result;
  while (!queue.empty()) {
    const auto [key, kind, a, b, length] = queue.top();
    queue.pop();
    if (sets[a] == sets[b]) continue;
    if (kind == bounded) {
      contacts::Closest_pair closest;
      surfaces[a]->improve_closest(*surfaces[b], closest);
      const double exact = std::sqrt(closest.squared);
      queue.emplace(quantized(exact), measured, a, b, exact);
      continue;
    }
    sets.unite(a, b);
    result.push_back({{a, b}, length});
  }
  return result;
}

/// The widest gap that it takes to join all surfaces.
inline double widest_gap(const std::vector<contacts::Triangle_tree>& surfaces)
{
  std::vector<const contacts::Triangle_tree*> pointers;
  for (const contacts::Triangle_tree& surface : surfaces)
    pointers.push_back(&surface);
  const std::vector<Joining_way> ways = joining_ways(pointers, Disjoint_sets(surfaces.size()));
  return ways.empty() ? 0 : ways.back().length;
}

inline std::vector<contacts::Triangle_tree> trees_of(const std::vector<Part_mesh>& parts)
{
  std::vector<contacts::Triangle_tree> result;
  for (const Part_mesh& part : parts)
    result.push_back(tree_of(part.points, part.triangles));
  return result;
}

} // namespace internal
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_BLEND_JOINING_WAYS_H

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/surface_components.h"

#include "base/Disjoint_sets.h"
#include "base/quantized.h"

#include <cmath>
#include <functional>
#include <queue>
#include <tuple>

namespace CGAL::Shape_correspondence::internal {

std::vector<contacts::Triangle_tree> trees_of(const std::vector<Part_mesh>& parts)
{
  std::vector<contacts::Triangle_tree> result;
  for (const Part_mesh& part : parts)
    result.push_back(tree_of(part.points, part.triangles));
  return result;
}

Tree_pointers pointers_to(const std::vector<contacts::Triangle_tree>& trees)
{
  Tree_pointers result;
  for (const contacts::Triangle_tree& tree : trees)
    result.push_back(&tree);
  return result;
}

double widest_gap(const Tree_pointers& surfaces, double enough)
{
  constexpr bool measured = false, bounded = true; // what is measured comes first
  using Candidate = std::tuple<Steps, bool, std::size_t, std::size_t, double>;
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<Candidate>> queue;
  Disjoint_sets components(surfaces.size());
  double result = 0;
  for (std::size_t a = 0; a < surfaces.size(); ++a)
    for (std::size_t b = a + 1; b < surfaces.size(); ++b) {
      const double bound = surfaces[a]->box().exteriorDistance(surfaces[b]->box());
      const bool may_touch = enough > 0 && bound <= enough && components[a] != components[b];
      if (may_touch && surfaces[a]->is_within(*surfaces[b], enough * enough)) {
        components.unite(a, b);
        result = enough;
      } else {
        queue.emplace(quantized(bound), bounded, a, b, bound);
      }
    }
  while (components.number_of_sets() > 1) {
    const auto [key, kind, a, b, length] = queue.top();
    queue.pop();
    if (components[a] == components[b]) continue;
    if (kind == bounded) {
      contacts::Closest_pair closest;
      surfaces[a]->improve_closest(*surfaces[b], closest);
      const double exact = std::sqrt(closest.squared);
      queue.emplace(quantized(exact), measured, a, b, exact);
    } else {
      components.unite(a, b);
      result = length;
    }
  }
  return result;
}

} // namespace CGAL::Shape_correspondence::internal

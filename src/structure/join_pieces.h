// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "base/Disjoint_sets.h"

#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <queue>
#include <string>
#include <tuple>
#include <vector>

namespace CGAL::Shape_correspondence::internal {
namespace contacts {

/// Two parts and their distance, which is 0 where they overlap.
struct Near_pair
{
  std::array<std::size_t, 2> parts;
  double distance;
  std::size_t region; ///< index into the caller's list of places
};

inline std::string join_warning(const std::vector<Part_abstraction>& parts, const Near_pair& pair, double diagonal)
{
  const double percent = std::round(1000 * pair.distance / diagonal) / 10;
  std::string digits = std::to_string(percent);
  digits.resize(digits.find_first_of(".,") + 2);
  return "Parts '" + parts[pair.parts[0]].name + "' and '" + parts[pair.parts[1]].name +
         "' are taken to be in contact across a gap of " + digits +
         " % of the shape's diagonal, since the shape would fall into pieces otherwise.";
}

/// Connects the connected components that the near pairs leave, by the closest pairs (Kruskal's minimum spanning
/// forest). A distance is computed only once its lower bound is the least.
/// \tparam LowerBound maps two parts to a lower bound of their distance
/// \tparam Measure maps two parts to a `Near_pair`
template <typename LowerBound, typename Measure>
void join_pieces(const std::vector<Part_abstraction>& parts, double diagonal, const LowerBound& lower_bound,
                 const Measure& measure, std::vector<Near_pair>& near, std::vector<std::string>& warnings)
{
  Disjoint_sets pieces(parts.size());
  for (const Near_pair& pair : near)
    pieces.unite(pair.parts[0], pair.parts[1]);
  if (pieces.number_of_sets() == 1) return;

  // (distance or its lower bound, first part, second part, whether the distance is exact); the smallest first
  using Entry = std::tuple<double, std::size_t, std::size_t, bool>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  for (std::size_t a = 0; a < parts.size(); ++a)
    for (std::size_t b = a + 1; b < parts.size(); ++b)
      if (pieces[a] != pieces[b]) queue.emplace(lower_bound(a, b), a, b, false);
  while (pieces.number_of_sets() > 1 && !queue.empty()) {
    const auto [distance, a, b, measured] = queue.top();
    queue.pop();
    if (pieces[a] == pieces[b]) continue;
    const Near_pair pair = measure(a, b);
    if (!measured && pair.distance > distance) {
      queue.emplace(pair.distance, a, b, true);
      continue;
    }
    pieces.unite(a, b);
    near.push_back(pair);
    warnings.push_back(join_warning(parts, pair, diagonal));
  }
}

inline void sort_by_parts(std::vector<Near_pair>& near)
{
  std::sort(near.begin(), near.end(), [](const Near_pair& a, const Near_pair& b) { return a.parts < b.parts; });
}

} // namespace contacts
} // namespace CGAL::Shape_correspondence::internal

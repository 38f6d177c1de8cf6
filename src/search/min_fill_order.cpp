// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "search/min_fill_order.h"

#include <algorithm>

namespace CGAL::Shape_correspondence::internal {

std::vector<std::size_t> min_fill_order(std::size_t n, const std::vector<std::pair<std::size_t, std::size_t>>& edges,
                                        const Deadline& deadline)
{
  std::vector<char> adjacent(n * n, 0);
  std::vector<std::vector<std::size_t>> neighbours(n); // among vertices that are not yet eliminated
  const auto connect = [&](std::size_t a, std::size_t b) {
    if (a == b || adjacent[a * n + b]) return;
    adjacent[a * n + b] = adjacent[b * n + a] = 1;
    neighbours[a].push_back(b);
    neighbours[b].push_back(a);
  };
  for (const auto& edge : edges)
    connect(edge.first, edge.second);
  const auto fill_of = [&](std::size_t v) {
    deadline.check();
    std::size_t fill = 0;
    for (std::size_t i = 0; i < neighbours[v].size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        fill += !adjacent[neighbours[v][i] * n + neighbours[v][j]];
    return fill;
  };

  std::vector<std::size_t> fill(n), order;
  for (std::size_t v = 0; v < n; ++v)
    fill[v] = fill_of(v);
  std::vector<char> eliminated(n, 0), touched(n, 0);
  for (std::size_t step = 0; step < n; ++step) {
    std::size_t best = n;
    for (std::size_t v = 0; v < n; ++v)
      if (!eliminated[v] && (best == n || fill[v] < fill[best])) best = v;
    eliminated[best] = 1;
    order.push_back(best);
    const std::vector<std::size_t> around = neighbours[best];
    for (std::size_t a : around)
      neighbours[a].erase(std::find(neighbours[a].begin(), neighbours[a].end(), best));
    for (std::size_t a : around)
      for (std::size_t b : around)
        connect(a, b);
    // The fill of a vertex depends on the edges among its neighbours, which changed
    std::fill(touched.begin(), touched.end(), 0);
    for (std::size_t a : around) {
      touched[a] = 1;
      for (std::size_t b : neighbours[a])
        touched[b] = 1;
    }
    for (std::size_t v = 0; v < n; ++v)
      if (touched[v]) fill[v] = fill_of(v);
  }
  std::reverse(order.begin(), order.end());
  return order;
}

} // namespace CGAL::Shape_correspondence::internal

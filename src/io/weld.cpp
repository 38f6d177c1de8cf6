// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/model_parts.h"

#include <algorithm>
#include <numeric>

namespace CGAL {
namespace Shape_correspondence {
namespace IO {
namespace {

bool lexicographically_less(const Point& p, const Point& q)
{
  return std::lexicographical_compare(p.data(), p.data() + 3, q.data(), q.data() + 3);
}

/// For every corner the first corner at the same place.
std::vector<int> first_at_same_place(const std::vector<Point>& corners)
{
  std::vector<int> order(corners.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return lexicographically_less(corners[a], corners[b]); });
  std::vector<int> first(corners.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && corners[order[i]] == corners[order[i - 1]];
    first[order[i]] = same ? first[order[i - 1]] : order[i];
  }
  return first;
}

} // namespace

Part_mesh weld(const std::vector<Point>& corners)
{
  const std::vector<int> first = first_at_same_place(corners);
  std::vector<int> vertex(corners.size(), -1);
  std::vector<int> used; // corner that stands for each vertex
  std::vector<Eigen::Vector3i> triangles;
  for (std::size_t t = 0; t + 2 < corners.size(); t += 3) {
    const Eigen::Vector3i c(first[t], first[t + 1], first[t + 2]);
    if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0]) continue;
    for (int corner : c) {
      if (vertex[corner] < 0) {
        vertex[corner] = static_cast<int>(used.size());
        used.push_back(corner);
      }
    }
    triangles.emplace_back(vertex[c[0]], vertex[c[1]], vertex[c[2]]);
  }
  Part_mesh mesh;
  mesh.points.resize(3, used.size());
  for (std::size_t i = 0; i < used.size(); ++i)
    mesh.points.col(i) = corners[used[i]];
  mesh.triangles.resize(3, triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i)
    mesh.triangles.col(i) = triangles[i];
  return mesh;
}

} // namespace IO
} // namespace Shape_correspondence
} // namespace CGAL

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// The triangles across the edges of a mesh, by triangle; none across edges of more than two triangles.
inline std::vector<std::vector<int>> neighbours_of(const Part_mesh& mesh)
{
  std::map<std::pair<int, int>, std::vector<int>> edges;
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t)
    for (int k = 0; k < 3; ++k)
      edges[std::minmax(mesh.triangles(k, t), mesh.triangles((k + 1) % 3, t))].push_back(int(t));
  std::vector<std::vector<int>> result(std::size_t(mesh.triangles.cols()));
  for (const auto& [edge, triangles] : edges) {
    if (triangles.size() != 2) continue;
    result[std::size_t(triangles[0])].push_back(triangles[1]);
    result[std::size_t(triangles[1])].push_back(triangles[0]);
  }
  return result;
}

/// Sets the value of each triangle to the most frequent one of its neighbours, in three rounds.
/// \param may_have whether a triangle may have a value
template <typename May_have>
void smooth(const std::vector<std::vector<int>>& neighbours, std::vector<int>& values, const May_have& may_have)
{
  for (int round = 0; round < 3; ++round) {
    const std::vector<int> before = values;
    for (std::size_t t = 0; t < values.size(); ++t)
      for (int neighbour : neighbours[t]) {
        const int value = before[std::size_t(neighbour)];
        const auto has_it = [&](int other) { return before[std::size_t(other)] == value; };
        if (std::count_if(neighbours[t].begin(), neighbours[t].end(), has_it) >= 2 && may_have(t, value))
          values[t] = value;
      }
  }
}

} // namespace CGAL::Shape_correspondence::internal

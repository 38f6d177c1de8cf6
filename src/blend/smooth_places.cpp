// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/smooth_places.h"

#include <cstddef>

namespace CGAL::Shape_correspondence::internal {
namespace {

/// Calls `visit(a, b)` for every side of every triangle.
template <typename Visit>
void for_each_side(const Eigen::Matrix3Xi& triangles, const Visit& visit)
{
  for (Eigen::Index t = 0; t < triangles.cols(); ++t)
    for (int i = 0; i < 3; ++i)
      visit(triangles(i, t), triangles((i + 1) % 3, t));
}

/// The vertices at ends of edges that a displacement stretches.
std::vector<char> stretched_vertices(const Points& vertices, const Points& displacements,
                                     const Eigen::Matrix3Xi& triangles)
{
  constexpr double most_stretch = 1.5;
  constexpr double no_length = 1e-9; // in coordinates
  std::vector<char> result(std::size_t(vertices.cols()), 0);
  for_each_side(triangles, [&](int a, int b) {
    const Point edge = vertices.col(b) - vertices.col(a);
    const Point moved = edge + displacements.col(b) - displacements.col(a);
    if (moved.norm() > most_stretch * edge.norm() + no_length) result[std::size_t(a)] = result[std::size_t(b)] = 1;
  });
  return result;
}

/// By vertex, the mean of its displacement and those at the other ends of the sides of its triangles.
Points mean_displacements(const Points& displacements, const Eigen::Matrix3Xi& triangles)
{
  Points sums = displacements;
  Eigen::RowVectorXd counts = Eigen::RowVectorXd::Ones(displacements.cols());
  for_each_side(triangles, [&](int a, int b) {
    sums.col(a) += displacements.col(b);
    sums.col(b) += displacements.col(a);
    ++counts[a];
    ++counts[b];
  });
  return sums.array().rowwise() / counts.array();
}

} // namespace

std::vector<Mesh_place> smooth_places(const Points& vertices, const Eigen::Matrix3Xi& triangles, const Points& onto,
                                      const Eigen::Matrix3Xi& onto_triangles)
{
  constexpr int most_rounds = 10;
  const contacts::Triangle_tree tree = tree_of(onto, onto_triangles);
  std::vector<Mesh_place> result(std::size_t(vertices.cols()));
  Points displacements = Points::Zero(3, vertices.cols());
  std::vector<char> is_to_move(result.size(), 1);
  for (int round = 0; round <= most_rounds; ++round) {
    const Points wanted = vertices + mean_displacements(displacements, triangles);
    bool any = false;
    for (std::size_t i = 0; i < result.size(); ++i) {
      if (!is_to_move[i]) continue;
      const auto at = Eigen::Index(i);
      result[i] = nearest_place(tree, wanted.col(at));
      displacements.col(at) = result[i].of(onto, onto_triangles) - vertices.col(at);
      any = true;
    }
    if (!any) break;
    is_to_move = stretched_vertices(vertices, displacements, triangles);
  }
  return result;
}

} // namespace CGAL::Shape_correspondence::internal

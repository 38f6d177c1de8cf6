// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "shape/triangles_below.h"
#include "shape/Triangle_tree.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <optional>

namespace CGAL::Shape_correspondence::internal {

namespace {

using Corner_key = std::array<std::array<double, 3>, 3>;

/// The corners of a triangle in orientation order, the lexicographically least first, to compare triangles.
Corner_key corner_key(const Part_mesh& mesh, Eigen::Index t)
{
  Corner_key result;
  for (std::size_t k = 0; k < 3; ++k)
    std::copy_n(mesh.points.col(mesh.triangles(Eigen::Index(k), t)).data(), 3, result[k].data());
  std::rotate(result.begin(), std::min_element(result.begin(), result.end()), result.end());
  return result;
}

std::size_t nearest_triangle(const contacts::Triangle_tree& tree, const Point& p)
{
  Point nearest = p;
  double squared = std::numeric_limits<double>::infinity();
  std::size_t triangle = 0;
  tree.improve_nearest(p, nearest, squared, triangle);
  return tree.given_number(triangle);
}

} // namespace

std::vector<std::size_t> triangles_below(const Part_mesh& mesh, const Part_mesh& on_it)
{
  std::map<Corner_key, std::size_t> known;
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t)
    known.emplace(corner_key(mesh, t), std::size_t(t));
  std::optional<contacts::Triangle_tree> tree;
  std::vector<std::size_t> result;
  for (Eigen::Index t = 0; t < on_it.triangles.cols(); ++t) {
    const auto same = known.find(corner_key(on_it, t));
    if (same == known.end() && !tree) tree = tree_of(mesh.points, mesh.triangles);
    result.push_back(same != known.end() ? same->second
                                         : nearest_triangle(*tree, contacts::centre(triangle_of(on_it, t))));
  }
  return result;
}

} // namespace CGAL::Shape_correspondence::internal

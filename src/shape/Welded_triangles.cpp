// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "shape/Welded_triangles.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <utility>

namespace CGAL::Shape_correspondence::internal {

Welded_triangles::Welded_triangles(const Segmented_shape& shape, const Eigen::Matrix3d& axes)
{
  collect(shape, axes);
  weld();
  find_edges();
}

bool Welded_triangles::is_degenerate(std::size_t t) const
{
  return place(t, 0) == place(t, 1) || place(t, 1) == place(t, 2) || place(t, 2) == place(t, 0);
}

std::vector<Numbers> Welded_triangles::triangles_of_places() const
{
  std::vector<Numbers> result(numbers_in(places));
  for (std::size_t t = 0; t < size(); ++t)
    for (int k = 0; k < 3; ++k)
      result[place(t, k)].push_back(t);
  return result;
}

double Welded_triangles::length(const Triangle_side& edge) const
{
  return (corner(edge.triangle, (edge.corner + 1) % 3) - corner(edge.triangle, edge.corner)).norm();
}

double Welded_triangles::cosine(const Triangle_side& a, const Triangle_side& b) const
{
  const double d = normals[a.triangle].dot(normals[b.triangle]);
  return a.is_forward == b.is_forward ? -d : d;
}

void Welded_triangles::collect(const Segmented_shape& shape, const Eigen::Matrix3d& axes)
{
  std::vector<Point> vertices;
  Eigen::AlignedBox3d box;
  for (std::size_t i = 0; i < shape.parts().size(); ++i) {
    const Part_mesh& mesh = shape.parts()[i].mesh;
    const std::size_t begin = vertices.size();
    for (Eigen::Index v = 0; v < mesh.points.cols(); ++v)
      vertices.push_back(axes * mesh.points.col(v));
    for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
      corners.push_back({});
      for (int k = 0; k < 3; ++k) {
        corners.back()[std::size_t(k)] = begin + std::size_t(mesh.triangles(k, t));
        box.extend(vertices[corners.back()[std::size_t(k)]]);
      }
      objects.push_back(i);
    }
  }
  const double diagonal = box.diagonal().norm();
  sides = box.diagonal() / diagonal;
  points.resize(3, Eigen::Index(vertices.size()));
  for (std::size_t v = 0; v < vertices.size(); ++v)
    points.col(Eigen::Index(v)) = (vertices[v] - box.min()) / diagonal;
  for (std::size_t t = 0; t < corners.size(); ++t) {
    const Point normal = (corner(t, 1) - corner(t, 0)).cross(corner(t, 2) - corner(t, 0));
    const double twice = normal.norm();
    areas.push_back(twice / 2);
    normals.push_back(normal / std::max(twice, 1e-30));
    area += twice / 2;
  }
}

void Welded_triangles::weld()
{
  constexpr std::size_t most_compared = 8; // points compared in a cell, which are all welded in any case
  Disjoint_sets sets(std::size_t(points.cols()));
  const Point_grid grid(points, welding_distance / 2);
  grid.for_each_cell([&](const Numbers& of_cell) {
    for (std::size_t i : of_cell)
      sets.unite(of_cell[0], i);
    grid.for_each_near(of_cell[0], welding_distance, most_compared,
                       [&](std::size_t j, double) { sets.unite(of_cell[0], j); });
  });
  places = numbers_of_sets(sets);
}

void Welded_triangles::find_edges()
{
  for (std::size_t t = 0; t < corners.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const std::size_t a = place(t, k), b = place(t, (k + 1) % 3);
      if (a != b) edges.push_back({std::min(a, b), std::max(a, b), t, k, a < b});
    }
  std::stable_sort(edges.begin(), edges.end(), [](const Triangle_side& a, const Triangle_side& b) {
    return std::pair(a.low, a.high) < std::pair(b.low, b.high);
  });
}

Numbers numbers_of_sets(const Disjoint_sets& sets)
{
  Numbers result(sets.size()), number(sets.size(), sets.size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < sets.size(); ++i) {
    std::size_t& n = number[sets[i]];
    if (n == sets.size()) n = count++;
    result[i] = n;
  }
  return result;
}

std::size_t numbers_in(const Numbers& numbers)
{
  return numbers.empty() ? 0 : 1 + *std::max_element(numbers.begin(), numbers.end());
}

} // namespace CGAL::Shape_correspondence::internal

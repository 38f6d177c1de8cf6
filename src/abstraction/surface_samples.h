// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "shape/triangle_distance.h"

#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// Prefix sums of the areas of triangles.
inline std::vector<double> cumulative_areas(const Part_mesh& mesh)
{
  std::vector<double> result;
  double sum = 0;
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t)
    result.push_back(sum += 0.5 * contacts::area_vector(triangle_of(mesh, t)).norm());
  return result;
}

inline double surface_area(const Part_mesh& mesh)
{
  const std::vector<double> areas = cumulative_areas(mesh);
  return areas.empty() ? 0. : areas.back();
}

inline double enclosed_volume(const Part_mesh& mesh)
{
  double result = 0;
  const Point origin = mesh.points.rowwise().mean();
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
    const auto [a, b, c] = triangle_of(mesh, t);
    result += (a - origin).dot((b - origin).cross(c - origin)) / 6;
  }
  return std::abs(result);
}

/// Points distributed by area with a low-discrepancy sequence: no random numbers, no clumps.
inline Points points_by_area(const Part_mesh& mesh, std::size_t n)
{
  // Powers of the inverse of the generalized golden ratio in three dimensions (Roberts 2018).
  const double step[] = {0.8191725133961645, 0.6710436067037893, 0.5497004779019703};
  const std::vector<double> areas = cumulative_areas(mesh);
  Points result(3, Eigen::Index(n));
  for (std::size_t i = 0; i < n; ++i) {
    const auto fraction = [&](int k) { return std::fmod(0.5 + step[k] * double(i + 1), 1.); };
    const auto found = std::upper_bound(areas.begin(), areas.end() - 1, fraction(0) * areas.back());
    const auto t = Eigen::Index(found - areas.begin());
    double u = fraction(1), v = fraction(2);
    if (u + v > 1) {
      u = 1 - u;
      v = 1 - v;
    }
    const auto [a, b, c] = triangle_of(mesh, t);
    result.col(Eigen::Index(i)) = (1 - u - v) * a + u * b + v * c;
  }
  return result;
}

/// The vertices that triangles use; empty if there are more than `limit`.
inline std::vector<Eigen::Index> used_vertices(const Part_mesh& mesh, std::size_t limit)
{
  std::vector<char> used(std::size_t(mesh.points.cols()), 0);
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
    for (int k = 0; k < 3; ++k)
      used[std::size_t(mesh.triangles(k, t))] = 1;
  }
  std::vector<Eigen::Index> result;
  for (std::size_t v = 0; v < used.size(); ++v)
    if (used[v]) result.push_back(Eigen::Index(v));
  if (result.size() > limit) result.clear();
  return result;
}

/// Picks `n` of the points, each the farthest from those picked before.
inline Points farthest_points(const Points& candidates, std::size_t n)
{
  // Of nearly equally far points the first one wins, so that noise does not decide.
  const double nearly = 1 - 1e-4;
  using Row = Eigen::Array<double, 1, Eigen::Dynamic>;
  const Row x = candidates.row(0), y = candidates.row(1), z = candidates.row(2); // contiguous copies for speed
  const auto squared_distances = [&](const Point& p) {
    return (x - p.x()).square() + (y - p.y()).square() + (z - p.z()).square();
  };
  Row squared = squared_distances(candidates.rowwise().mean());
  Points result(3, Eigen::Index(n));
  for (std::size_t i = 0; i < n; ++i) {
    const double farthest = nearly * squared.maxCoeff();
    Eigen::Index chosen = 0;
    while (squared[chosen] < farthest)
      ++chosen;
    const Point p = candidates.col(chosen);
    result.col(Eigen::Index(i)) = p;
    if (i == 0)
      squared = squared_distances(p);
    else
      squared = squared.min(squared_distances(p));
  }
  return result;
}

/// Points evenly spread over a surface. Vertices are candidates, too, if they are few, so that corners are among them.
inline Points even_surface_points(const Part_mesh& mesh, std::size_t n)
{
  const std::size_t candidates_a_point = 8;
  const Points by_area = points_by_area(mesh, candidates_a_point * n);
  const std::vector<Eigen::Index> corners = used_vertices(mesh, candidates_a_point * n);
  Points candidates(3, by_area.cols() + Eigen::Index(corners.size()));
  candidates.leftCols(by_area.cols()) = by_area;
  for (std::size_t c = 0; c < corners.size(); ++c)
    candidates.col(by_area.cols() + Eigen::Index(c)) = mesh.points.col(corners[c]);
  return farthest_points(candidates, n);
}

} // namespace CGAL::Shape_correspondence::internal

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "shape/oriented_box.h"
#include "shape/triangle_distance.h"

#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {
namespace contacts {

/// Points on a piece of surface and the area that each stands for.
struct Surface_samples
{
  std::vector<Point> points;
  std::vector<double> areas;
};

/// A triangle, given by a corner and the two sides from it, with its area.
struct Sampled_triangle
{
  Point corner, side_1, side_2;
  double area;
};

inline std::vector<Sampled_triangle> sampled_triangles_of(const Part_mesh& mesh)
{
  std::vector<Sampled_triangle> result;
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
    const Triangle corners = triangle_of(mesh, t);
    const Point u = corners[1] - corners[0], v = corners[2] - corners[0];
    result.push_back({corners[0], u, v, u.cross(v).norm() / 2});
  }
  return result;
}

inline double total_area(const std::vector<Sampled_triangle>& triangles)
{
  double sum = 0;
  for (const Sampled_triangle& t : triangles)
    sum += t.area;
  return sum;
}

/// `n` points, evenly spread by area; the k-th takes its place in its triangle from a low-discrepancy sequence.
inline Surface_samples sample_triangles(const std::vector<Sampled_triangle>& triangles, int n)
{
  constexpr double step_1 = 0.7548776662466927, step_2 = 0.5698402909980532; // inverse plastic number and its square
  const double total = total_area(triangles);
  Surface_samples samples;
  std::size_t current = 0;
  double passed = 0;
  for (int k = 0; k < n && !triangles.empty(); ++k) {
    const double target = (k + 0.5) / n * total;
    while (current + 1 < triangles.size() && passed + triangles[current].area < target)
      passed += triangles[current++].area;
    double u = std::fmod((k + 1) * step_1, 1.0), v = std::fmod((k + 1) * step_2, 1.0);
    if (u + v > 1) u = 1 - u, v = 1 - v;
    const Sampled_triangle& t = triangles[current];
    samples.points.push_back(t.corner + u * t.side_1 + v * t.side_2);
    samples.areas.push_back(total / n);
  }
  return samples;
}

} // namespace contacts

/// Whether a mesh has an area above rounding noise, not only slivers.
inline bool has_area(const Part_mesh& mesh)
{
  // Relative to the squared extent, so that the unit of length does not matter.
  const double smallest = 1e-14;
  const double extent = diagonal(mesh.points);
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t)
    if (contacts::area_vector(triangle_of(mesh, t)).norm() > smallest * extent * extent) return true;
  return false;
}

} // namespace CGAL::Shape_correspondence::internal

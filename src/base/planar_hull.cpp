// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/planar_hull.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace CGAL::Shape_correspondence::internal {
namespace {

constexpr double relative_noise = 1e-9; // of the area of a triangle, over the square of the points' extent
constexpr double equal_areas = 1e-6;    // relative difference of areas that are taken to be equal

} // namespace

Planar_points planar_hull(Planar_points points)
{
  std::sort(points.begin(), points.end(),
            [](const auto& a, const auto& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
  if (points.size() < 3) {
    return points;
  }
  double extent = 0;
  for (const auto& p : points) {
    extent = std::max(extent, (p - points.front()).cwiseAbs().maxCoeff());
  }
  const double tolerance = relative_noise * extent * extent;
  Planar_points hull;
  const auto add_chain = [&](auto begin, auto end) {
    const std::size_t start = hull.size();
    for (auto p = begin; p != end; ++p) {
      while (hull.size() >= start + 2 &&
             cross(hull.back() - hull[hull.size() - 2], *p - hull[hull.size() - 2]) <= tolerance) {
        hull.pop_back();
      }
      hull.push_back(*p);
    }
    hull.pop_back();
  };
  add_chain(points.begin(), points.end());
  add_chain(points.rbegin(), points.rend());
  return hull;
}

Eigen::Vector2d least_rectangle_direction(const Planar_points& hull)
{
  Eigen::Vector2d result = Eigen::Vector2d::UnitX();
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Eigen::Vector2d edge = hull[(i + 1) % hull.size()] - hull[i];
    if (!(edge.norm() > 0)) {
      continue;
    }
    Eigen::Matrix2d axes;
    axes.col(0) = edge.normalized();
    axes.col(1) << -axes(1, 0), axes(0, 0);
    Eigen::Array2d low = Eigen::Array2d::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (const auto& p : hull) {
      const Eigen::Array2d x = (axes.transpose() * p).array();
      low = low.min(x);
      high = high.max(x);
    }
    const double area = (high - low).prod();
    if (area < least * (1 - equal_areas)) {
      least = area;
      result = axes.col(0);
    }
  }
  return result;
}

} // namespace CGAL::Shape_correspondence::internal

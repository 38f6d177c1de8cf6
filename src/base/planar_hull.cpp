// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/planar_hull.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL::Shape_correspondence::internal {
namespace {

constexpr double relative_noise = 1e-9; // greatest cross product that is rounding noise, over the squared extent
constexpr double equal_areas = 1e-6;    // relative difference of areas that count as equal
constexpr double equal_sines = 1e-6;    // difference of sines of angles that count as equal

/// Of the directions of a rectangle's sides, the one whose angle from the x axis is in (-45°, 45°].
Eigen::Vector2d side_along_x(Eigen::Vector2d side)
{
  const auto is_along_x = [&] { return side.y() > equal_sines - side.x() && side.y() < side.x() + equal_sines; };
  for (int turns = 0; turns < 3 && !is_along_x(); ++turns)
    side = quarter_turn(side);
  return side;
}

/// Whether a side is turned less from the x axis than another; of equal angles, the one to the left counts as less.
bool is_turned_less(const Eigen::Vector2d& side, const Eigen::Vector2d& other)
{
  const double more = std::abs(side.y()) - std::abs(other.y());
  return more < -equal_sines || (more < equal_sines && side.y() > 0 && other.y() < 0);
}

} // namespace

Planar_points planar_hull(Planar_points points)
{
  std::sort(points.begin(), points.end(),
            [](const auto& a, const auto& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
  if (points.size() < 3) return points;
  double extent = 0;
  for (const auto& p : points)
    extent = std::max(extent, (p - points.front()).cwiseAbs().maxCoeff());
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
    if (!(edge.norm() > 0)) continue;
    const Eigen::Vector2d side = side_along_x(edge.normalized());
    Eigen::Matrix2d axes;
    axes << side, quarter_turn(side);
    Eigen::Array2d low = Eigen::Array2d::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (const auto& p : hull) {
      const Eigen::Array2d x = (axes.transpose() * p).array();
      low = low.min(x);
      high = high.max(x);
    }
    const double area = (high - low).prod();
    const bool is_less = area < least * (1 - equal_areas), is_equal = !is_less && area < least * (1 + equal_areas);
    if (is_less || (is_equal && is_turned_less(side, result))) result = side;
    least = std::min(least, area);
  }
  return result;
}

} // namespace CGAL::Shape_correspondence::internal

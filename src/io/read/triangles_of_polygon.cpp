// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read/model_parts.h"
#include "shape/divide_polygon.h"

#include <Eigen/Geometry>

#include <numeric>

namespace CGAL::Shape_correspondence::IO {
namespace {

// Twice the area of a corner's triangle, over the polygon's area, below which the corner counts as straight.
constexpr double straight = 1e-12;

// Number of corners up to which ears are clipped, which takes cubic time in the worst case.
constexpr std::size_t most_corners = 1000;

/// Triangulates a polygon projected along `normal`, O(n log n) for n corners; none if the projection touches or crosses
/// itself.
std::vector<std::size_t> triangles_in_plane(const std::vector<Point>& polygon, const Point& normal)
{
  const int n = int(polygon.size());
  std::vector<internal::Link> border;
  for (int i = 0; i < n; ++i)
    border.push_back({i, (i + 1) % n});
  std::vector<std::size_t> result;
  for (const internal::Corners& triangle :
       internal::divide_polygon(polygon, border, {}, normal, Eigen::Matrix3d::Identity()))
    result.insert(result.end(), triangle.begin(), triangle.end());
  return result;
}

/// Twice the area vector of a polygon (Newell).
Point area_vector(const std::vector<Point>& polygon)
{
  Point sum = Point::Zero();
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    sum += (polygon[i] - polygon[0]).cross(polygon[i + 1] - polygon[0]);
  return sum;
}

double signed_area(const Point& a, const Point& b, const Point& c, const Point& normal)
{
  return (b - a).cross(c - a).dot(normal);
}

bool is_convex(const std::vector<Point>& polygon, const Point& normal, double tolerance)
{
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (signed_area(polygon[i], polygon[(i + 1) % n], polygon[(i + 2) % n], normal) < -tolerance) return false;
  }
  return true;
}

/// Whether corner i of `rest` can be clipped: it is convex, and no other corner lies in its triangle.
bool is_ear(const std::vector<Point>& polygon, const std::vector<std::size_t>& rest, std::size_t i, const Point& normal)
{
  const std::size_t n = rest.size();
  const Point &a = polygon[rest[(i + n - 1) % n]], &b = polygon[rest[i]], &c = polygon[rest[(i + 1) % n]];
  if (signed_area(a, b, c, normal) <= 0) return false;
  for (std::size_t j = 0; j < n; ++j) {
    const Point& p = polygon[rest[j]];
    if (p == a || p == b || p == c) continue;
    if (signed_area(a, b, p, normal) >= 0 && signed_area(b, c, p, normal) >= 0 && signed_area(c, a, p, normal) >= 0)
      return false;
  }
  return true;
}

void add_fan(const std::vector<std::size_t>& polygon, std::vector<std::size_t>& triangles)
{
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    triangles.insert(triangles.end(), {polygon[0], polygon[i], polygon[i + 1]});
}

/// Triangulates the corners from `first` to `last` of a convex polygon by bisection, so that no corner is in many
/// triangles, as the first one of a fan is.
void add_halves(std::size_t first, std::size_t last, std::vector<std::size_t>& triangles)
{
  if (last - first < 2) return;
  const std::size_t middle = first + (last - first) / 2;
  triangles.insert(triangles.end(), {first, middle, last});
  add_halves(first, middle, triangles);
  add_halves(middle, last, triangles);
}

} // namespace

std::vector<std::size_t> triangles_of_polygon(const std::vector<Point>& polygon)
{
  std::vector<std::size_t> result, rest(polygon.size());
  std::iota(rest.begin(), rest.end(), std::size_t(0));
  const Point area = area_vector(polygon);
  const Point normal = area.normalized();
  const bool is_fan = polygon.size() < 4 || is_convex(polygon, normal, straight * area.norm());
  if (polygon.size() > most_corners) {
    if (!is_fan) result = triangles_in_plane(polygon, normal);
    // Self-intersecting polygons get an arbitrary triangulation
    if (result.empty()) add_halves(0, polygon.size() - 1, result);
    return result;
  }
  while (!is_fan && rest.size() > 3) {
    std::size_t ear = 0;
    while (ear < rest.size() && !is_ear(polygon, rest, ear, normal))
      ++ear;
    if (ear == rest.size()) break; // a self-intersecting polygon: an arbitrary triangulation suffices
    const std::size_t n = rest.size();
    result.insert(result.end(), {rest[(ear + n - 1) % n], rest[ear], rest[(ear + 1) % n]});
    rest.erase(rest.begin() + std::ptrdiff_t(ear));
  }
  add_fan(rest, result);
  return result;
}

} // namespace CGAL::Shape_correspondence::IO

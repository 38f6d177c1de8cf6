// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read/model_parts.h"

#include "shape/first_in_place.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <numeric>

namespace CGAL::Shape_correspondence::IO {
namespace {

// Corners that bend back by less than this, over the polygon's area, count as straight.
constexpr double straight = 1e-12;

// Corners of a polygon up to which ears are cut off, in time cubic in them at worst.
constexpr std::size_t most_corners = 1000;

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

/// Whether corner i of `rest` can be cut off: it bends outwards and no other corner lies in its triangle.
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
    if (result.empty()) add_halves(0, polygon.size() - 1, result); // also of one that crosses itself: any triangles do
    return result;
  }
  while (!is_fan && rest.size() > 3) {
    std::size_t ear = 0;
    while (ear < rest.size() && !is_ear(polygon, rest, ear, normal))
      ++ear;
    if (ear == rest.size()) break; // a polygon that crosses itself: any triangles do
    const std::size_t n = rest.size();
    result.insert(result.end(), {rest[(ear + n - 1) % n], rest[ear], rest[(ear + 1) % n]});
    rest.erase(rest.begin() + std::ptrdiff_t(ear));
  }
  add_fan(rest, result);
  return result;
}

Part_mesh weld(const std::vector<Point>& corners, std::vector<std::size_t>* kept)
{
  const double* coordinates = corners.empty() ? nullptr : corners[0].data();
  const std::vector<int> first =
      internal::first_in_place(Eigen::Map<const Points>(coordinates, 3, Eigen::Index(corners.size())));
  std::vector<int> vertex(corners.size(), -1);
  std::vector<int> used; // corner that stands for each vertex
  std::vector<Eigen::Vector3i> triangles;
  for (std::size_t t = 0; t + 2 < corners.size(); t += 3) {
    const Eigen::Vector3i c(first[t], first[t + 1], first[t + 2]);
    if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0]) continue;
    if (kept) kept->push_back(t / 3);
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

void add_mesh(const Part_mesh& more, Part_mesh& all)
{
  const Eigen::Index points = all.points.cols(), triangles = all.triangles.cols();
  all.points.conservativeResize(3, points + more.points.cols());
  all.points.rightCols(more.points.cols()) = more.points;
  all.triangles.conservativeResize(3, triangles + more.triangles.cols());
  all.triangles.rightCols(more.triangles.cols()) = more.triangles.array() + int(points);
}

Part_appearance looks_of(const Part_appearance& all, const std::vector<std::size_t>& triangles)
{
  const std::size_t needed = triangles.empty() ? 1 : triangles.back() + 1; // of attributes that the file has
  Part_appearance result;
  for (std::size_t t : triangles) {
    if (all.materials.size() >= needed) result.materials.push_back(all.materials[t]);
    for (std::size_t corner = 3 * t; corner < 3 * t + 3; ++corner) {
      if (all.coordinates.size() >= 3 * needed) result.coordinates.push_back(all.coordinates[corner]);
      if (all.colours.size() >= 3 * needed) result.colours.push_back(all.colours[corner]);
    }
  }
  return result;
}

void add_looks(const Part_appearance& more, std::size_t more_triangles, std::size_t triangles, Part_appearance& all)
{
  const auto append = [](auto& to, std::size_t before, const auto& from, std::size_t count, const auto& none) {
    if (to.empty() && from.empty()) return;
    to.resize(before, none);
    to.insert(to.end(), from.begin(), from.end());
    to.resize(before + count, none);
  };
  append(all.materials, triangles, more.materials, more_triangles, -1);
  append(all.coordinates, 3 * triangles, more.coordinates, 3 * more_triangles, Eigen::Vector2f(0, 0));
  append(all.colours, 3 * triangles, more.colours, 3 * more_triangles, Eigen::Vector3f(1, 1, 1));
}

std::pair<Part_mesh, Part_appearance> joined_parts(const Segmented_shape& shape, const Shape_appearance& appearance,
                                                   const std::vector<std::size_t>& parts)
{
  std::pair<Part_mesh, Part_appearance> result;
  for (std::size_t part : parts) {
    const Part_mesh& mesh = shape.parts()[part].mesh;
    add_looks(part < appearance.parts.size() ? appearance.parts[part] : Part_appearance(),
              std::size_t(mesh.triangles.cols()), std::size_t(result.first.triangles.cols()), result.second);
    add_mesh(mesh, result.first);
  }
  return result;
}

} // namespace CGAL::Shape_correspondence::IO

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read/model_parts.h"
#include "base/number_text.h"
#include "io/read/Gltf_document.h"
#include "io/read/text_words.h"
#include "shape/divide_polygon.h"
#include "shape/first_in_place.h"
#include "shape/meshes.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <Eigen/Geometry>

#include <cmath>
#include <numeric>

namespace CGAL::Shape_correspondence::IO {
namespace {

constexpr std::string_view beginning_of_mark = "shape_correspondence parts, up ";

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

Model_content read_gltf_parts(std::string_view text, const std::string& file, const Reading_options& options)
{
  try {
    return read_gltf(text, file, options, nullptr);
  } catch (const Needs_import& needs) {
    try {
      return import_parts(file, options);
    } catch (const Invalid_input& error) {
      throw Invalid_input(error.what() + (" (it needs " + needs.what + ")"));
    }
  }
}

std::string mark_of_parts(const Point& up)
{
  std::string result(beginning_of_mark);
  for (int axis = 0; axis < 3; ++axis)
    result += (axis > 0 ? " " : "") + internal::number_text(up[axis]);
  return result;
}

std::optional<Point> up_in_mark(std::string_view comment)
{
  if (!begins_with(comment, beginning_of_mark)) return std::nullopt;
  comment.remove_prefix(beginning_of_mark.size());
  Point up;
  for (double& coordinate : up)
    if (!parse(next_word(comment), coordinate)) return std::nullopt;
  if (!(std::abs(up.norm() - 1) < 1e-6)) return std::nullopt; // NaN fails as well
  return up;
}

Part_mesh weld(const std::vector<Point>& corners, std::vector<std::size_t>* kept)
{
  const double* coordinates = corners.empty() ? nullptr : corners[0].data();
  const Eigen::Map<const Points> points(coordinates, 3, Eigen::Index(corners.size()));
  const std::vector<int> first = internal::first_in_place(points);
  std::vector<int> vertex(corners.size(), -1);
  std::vector<int> used; // representative corner of each vertex
  std::vector<int> triangles;
  for (std::size_t t = 0; t + 2 < corners.size(); t += 3) {
    const Eigen::Vector3i c(first[t], first[t + 1], first[t + 2]);
    if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0]) continue;
    if (kept) kept->push_back(t / 3);
    for (int corner : c) {
      if (vertex[corner] < 0) {
        vertex[corner] = static_cast<int>(used.size());
        used.push_back(corner);
      }
      triangles.push_back(vertex[corner]);
    }
  }
  Part_mesh mesh;
  mesh.points = points(Eigen::indexing::all, used);
  mesh.triangles = Eigen::Map<const Eigen::Matrix3Xi>(triangles.data(), 3, Eigen::Index(triangles.size() / 3));
  return mesh;
}

std::pair<Part_mesh, Part_appearance> joined_parts(const Segmented_shape& shape, const Shape_appearance& appearance,
                                                   const std::vector<std::size_t>& parts)
{
  std::vector<const Part_mesh*> meshes;
  std::size_t triangles = 0;
  Part_appearance looks;
  for (std::size_t part : parts) {
    meshes.push_back(&shape.parts()[part].mesh);
    const auto more = std::size_t(meshes.back()->triangles.cols());
    add_appearance(part < appearance.parts.size() ? appearance.parts[part] : Part_appearance(), more, triangles, looks);
    triangles += more;
  }
  return {internal::joined(meshes), std::move(looks)};
}

} // namespace CGAL::Shape_correspondence::IO

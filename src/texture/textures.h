// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "base/clamped.h"
#include "base/planar_hull.h"

#include <CGAL/Shape_correspondence/Segmented_shape.h>
#include <CGAL/Shape_correspondence/Shape_appearance.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// The value at a point of a triangle, interpolated from its corners. \param weights barycentric coordinates
template <typename Number, typename Vector>
auto value_at(const std::vector<Vector>& of_corners, std::size_t triangle, const Eigen::Vector3d& weights)
{
  Eigen::Matrix<Number, Vector::RowsAtCompileTime, 1> result;
  result.setZero();
  for (std::size_t k = 0; k < 3; ++k)
    result += Number(weights[Eigen::Index(k)]) * of_corners[3 * triangle + k].template cast<Number>();
  return result;
}

/// Samples the colours of a shape's surface, in linear light.
class Appearance_sampler
{
public:
  /// \param appearance kept by reference \param neutral colour of parts without an appearance
  Appearance_sampler(const Shape_appearance& appearance, const Eigen::Vector3d& neutral);

  /// Whether a part has an appearance.
  bool is_known(std::size_t part) const;

  /// The colour of a point. \param weights its barycentric coordinates in the triangle
  Eigen::Vector3d operator()(std::size_t part, std::size_t triangle, const Eigen::Vector3d& weights) const;

private:
  Eigen::Vector3d texture_at(const Texture& texture, const Eigen::Vector2d& at) const;

  const Shape_appearance& appearance_;
  Eigen::Vector3d neutral_;
  std::array<double, 256> linear_; ///< linear light, by byte of an sRGB channel
};

/// The corners of a triangle in a square image, in pixels.
using Flat_triangle = std::array<Eigen::Vector2d, 3>;

/// The positions in an image of the triangles of all parts, by part and triangle.
using Texture_layout = std::vector<std::vector<Flat_triangle>>;

/// Barycentric coordinates of a point; not finite for a degenerate triangle.
inline Eigen::Vector3d barycentric_coordinates(const Flat_triangle& t, const Eigen::Vector2d& p)
{
  const double area = cross(t[1] - t[0], t[2] - t[0]);
  const double a = cross(t[1] - p, t[2] - p) / area, b = cross(t[2] - p, t[0] - p) / area;
  return {a, b, 1 - a - b};
}

/// The index of a pixel in an image, row by row.
inline std::size_t pixel_at(int x, int y, int size) { return std::size_t(y) * std::size_t(size) + std::size_t(x); }

/// Calls `visit` for the pixels whose centres are in the triangle.
/// \param inside least barycentric coordinate; if positive, pixels on borders between triangles are left out
template <typename Visit>
void for_each_pixel(const Flat_triangle& t, int size, const Visit& visit, double inside = -1e-9)
{
  const Eigen::Vector2d low = t[0].cwiseMin(t[1]).cwiseMin(t[2]), high = t[0].cwiseMax(t[1]).cwiseMax(t[2]);
  const int last = size - 1;
  for (int y = clamped_cell(low.y(), last); y <= clamped_cell(high.y(), last); ++y)
    for (int x = clamped_cell(low.x(), last); x <= clamped_cell(high.x(), last); ++x)
      if (barycentric_coordinates(t, {x + 0.5, y + 0.5}).minCoeff() >= inside) visit(pixel_at(x, y, size));
}

/// The layout given by the texture coordinates of a shape; none if a part has no coordinates, if they are outside of
/// [0, 1], or if triangles overlap, so that a pixel would need several colours.
std::optional<Texture_layout> given_layout(const Segmented_shape& shape, const Shape_appearance& appearance, int size);

/// A new layout: charts of connected triangles that face the same axis direction of `frame` (a rotation), projected
/// along it and packed at one scale, each with a margin of `margin` pixels, or fewer if there is no room.
Texture_layout new_layout(const Segmented_shape& shape, const Eigen::Matrix3d& frame, int size, int margin);

/// The linear colour of a point in a triangle of a part, by barycentric coordinates. Called from several threads.
using Colour_of_point =
    std::function<Eigen::Vector3d(std::size_t part, std::size_t triangle, const Eigen::Vector3d& weights)>;

/// Paints the triangles of a layout into an image; every pixel is the mean of `samples`² points. Colours are extended
/// across the borders of triangles by `margin` pixels; all other pixels have the colour `background`.
Image bake(const Texture_layout& layout, int size, int margin, int samples, const Eigen::Vector3d& background,
           const Colour_of_point& colour);

/// For each triangle of a mesh, those that share an edge with it; edges of more than two triangles do not count.
inline std::vector<std::vector<int>> neighbours_of(const Part_mesh& mesh)
{
  std::map<std::pair<int, int>, std::vector<int>> edges;
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t)
    for (int k = 0; k < 3; ++k)
      edges[std::minmax(mesh.triangles(k, t), mesh.triangles((k + 1) % 3, t))].push_back(int(t));
  std::vector<std::vector<int>> result(std::size_t(mesh.triangles.cols()));
  for (const auto& [edge, triangles] : edges) {
    if (triangles.size() != 2) continue;
    result[std::size_t(triangles[0])].push_back(triangles[1]);
    result[std::size_t(triangles[1])].push_back(triangles[0]);
  }
  return result;
}

/// Sets the value of each triangle to the most frequent one of its neighbours, in three rounds.
/// \param may_have whether a triangle, given by index, may have a value
template <typename May_have>
void smooth(const std::vector<std::vector<int>>& neighbours, std::vector<int>& values, const May_have& may_have)
{
  for (int round = 0; round < 3; ++round) {
    const std::vector<int> before = values;
    for (std::size_t t = 0; t < values.size(); ++t)
      for (int neighbour : neighbours[t]) {
        const int value = before[std::size_t(neighbour)];
        const auto has_it = [&](int other) { return before[std::size_t(other)] == value; };
        if (std::count_if(neighbours[t].begin(), neighbours[t].end(), has_it) >= 2 && may_have(t, value))
          values[t] = value;
      }
  }
}

} // namespace CGAL::Shape_correspondence::internal

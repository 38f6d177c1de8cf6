// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "shape/Triangle_tree.h"
#include "shape/sample_triangles.h"

#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {
namespace contacts {

inline Box widened(const Box& box, double by)
{
  return Box(box.min() - Point::Constant(by), box.max() + Point::Constant(by));
}

/// A convex polygon: a clipped triangle.
using Polygon = std::vector<Point>;

/// The polygon clipped to the half-space sign · coordinate ≤ sign · bound.
inline Polygon clipped(const Polygon& polygon, int axis, double bound, double sign)
{
  Polygon result;
  result.reserve(polygon.size() + 1);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double a = sign * (bound - p[axis]), b = sign * (bound - q[axis]);
    if (a >= 0) result.push_back(p);
    if ((a > 0 && b < 0) || (a < 0 && b > 0)) result.push_back(p + (a / (a - b)) * (q - p));
  }
  return result;
}

inline Polygon clipped(Polygon polygon, const Box& box)
{
  for (int axis = 0; axis < 3 && !polygon.empty(); ++axis) {
    polygon = clipped(polygon, axis, box.max()[axis], 1);
    polygon = clipped(polygon, axis, box.min()[axis], -1);
  }
  return polygon;
}

inline void add_fan(const Polygon& polygon, std::vector<Sampled_triangle>& triangles)
{
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const Point u = polygon[i - 1] - polygon[0], v = polygon[i] - polygon[0];
    const double area = u.cross(v).norm() / 2;
    if (area > 0) triangles.push_back({polygon[0], u, v, area});
  }
}

/// The surface of a part with a tree for distance queries.
class Part_surface
{
public:
  /// \param points vertices of the mesh, in the coordinates of the queries
  Part_surface(const Points& points, const Eigen::Matrix3Xi& triangles) : tree_(proper_triangles(points, triangles)) {}

  const Box& box() const { return tree_.box(); }
  const Triangle_tree& tree() const { return tree_; }

  /// Whether the other surface is inside, by the majority of three rays, since the mesh may have small holes.
  bool encloses(const Part_surface& other) const
  {
    if (other.tree_.triangles().empty() || !box().contains(other.box())) return false;
    const Point& p = other.tree_.triangles().front()[0];
    const std::array<Point, 3> directions = {Point(1, 0.1234, 0.0567), Point(-0.0891, 1, 0.1417),
                                             Point(0.1031, -0.0713, 1)};
    int odd = 0;
    for (const Point& direction : directions)
      odd += tree_.crossings(p, direction) % 2;
    return odd >= 2;
  }

  /// About `n` samples of the marked triangles inside `region`; if these are few, also clipped corners, with area 0.
  Surface_samples sample(const std::vector<char>& marked, const Box& region, int n) const
  {
    std::vector<Sampled_triangle> pieces;
    std::vector<Point> vertices;
    std::vector<std::size_t> order; // the triangles in the order of the mesh
    for (std::size_t t = 0; t < marked.size(); ++t)
      if (marked[t]) order.push_back(t);
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return tree_.given_number(a) < tree_.given_number(b); });
    for (std::size_t t : order) {
      const Triangle& triangle = tree_.triangles()[t];
      Polygon polygon(triangle.begin(), triangle.end());
      if (!region.contains(box_of(triangle))) polygon = clipped(std::move(polygon), region);
      add_fan(polygon, pieces);
      vertices.insert(vertices.end(), polygon.begin(), polygon.end());
    }
    Surface_samples samples = sample_triangles(pieces, n);
    if (vertices.size() <= static_cast<std::size_t>(n)) {
      samples.points.insert(samples.points.end(), vertices.begin(), vertices.end());
      samples.areas.resize(samples.points.size(), 0.0);
    }
    return samples;
  }

  Box box_of_marked(const std::vector<char>& marked) const
  {
    Box result;
    for (std::size_t t = 0; t < marked.size(); ++t)
      if (marked[t]) result.extend(box_of(tree_.triangles()[t]));
    return result;
  }

private:
  static std::vector<Triangle> proper_triangles(const Points& points, const Eigen::Matrix3Xi& triangles)
  {
    constexpr double least_relative_area = 1e-12; // twice the area, over the squared longest side
    std::vector<Triangle> result;
    for (Eigen::Index t = 0; t < triangles.cols(); ++t) {
      const Triangle corners = {points.col(triangles(0, t)), points.col(triangles(1, t)), points.col(triangles(2, t))};
      const Point u = corners[1] - corners[0], v = corners[2] - corners[0];
      const double longest = std::max({u.squaredNorm(), v.squaredNorm(), (v - u).squaredNorm()});
      if (u.cross(v).norm() > least_relative_area * longest) result.push_back(corners);
    }
    return result;
  }

  Triangle_tree tree_;
};

} // namespace contacts
} // namespace CGAL::Shape_correspondence::internal

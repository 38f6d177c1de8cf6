// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/planar_hull.h"
#include "base/quantized.h"

#include <CGAL/Shape_correspondence/estimate_up.h>

#include <CGAL/assertions.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace CGAL::Shape_correspondence {
using namespace internal;

namespace {

constexpr double base_height = 0.02;      // over the largest extent: vertices so near to the lowest one are the base
constexpr double horizontal_cosine = 0.9; // of a normal with the axis
constexpr double least_stability = -0.2;  // of a shape that falls over, however far its centre is off the base
constexpr double weight_of_horizontal = 0.5;

// What a choice of the upright axis is judged by, in units of the shape's largest extent.
struct Surface_summary
{
  Points vertices;
  Point centre = Point::Zero();     // of the surface
  Point horizontal = Point::Zero(); // by axis, the share of the surface that is perpendicular to it
};

Points all_vertices(const Segmented_shape& shape)
{
  Eigen::Index count = 0;
  for (const Shape_part& part : shape.parts())
    count += part.mesh.points.cols();
  Points result(3, count);
  for (const Shape_part& part : shape.parts()) {
    result.middleCols(result.cols() - count, part.mesh.points.cols()) = part.mesh.points;
    count -= part.mesh.points.cols();
  }
  return result;
}

Surface_summary summary_of_surface(const Segmented_shape& shape)
{
  Surface_summary result;
  result.vertices = all_vertices(shape);
  const Point low = result.vertices.rowwise().minCoeff();
  const double extent = (result.vertices.colwise() - low).maxCoeff();
  result.vertices = (result.vertices.colwise() - low) / extent;

  double area = 0;
  Eigen::Index first_vertex = 0;
  for (const Shape_part& part : shape.parts()) {
    for (Eigen::Index t = 0; t < part.mesh.triangles.cols(); ++t) {
      const auto corner = [&](int k) -> Point { return result.vertices.col(first_vertex + part.mesh.triangles(k, t)); };
      const Point normal = (corner(1) - corner(0)).cross(corner(2) - corner(0)) / 2;
      area += normal.norm();
      result.centre += normal.norm() * (corner(0) + corner(1) + corner(2)) / 3;
      for (int axis = 0; axis < 3; ++axis)
        if (std::abs(normal[axis]) > horizontal_cosine * normal.norm()) result.horizontal[axis] += normal.norm();
    }
    first_vertex += part.mesh.points.cols();
  }
  result.centre /= area;
  result.horizontal /= area;
  return result;
}

// How far a point is inside of a convex polygon, which is anticlockwise; negative outside of it.
double depth_inside(const Eigen::Vector2d& point, const Planar_points& hull)
{
  double depth = hull.size() < 3 ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < hull.size() && hull.size() > 2; ++i) {
    const Eigen::Vector2d edge = hull[(i + 1) % hull.size()] - hull[i];
    depth = std::min(depth, cross(edge, point - hull[i]) / edge.norm());
  }
  return depth;
}

// How well the shape stands if an axis points up.
double uprightness(const Surface_summary& surface, int axis)
{
  const int side = (axis + 1) % 3, front = (axis + 2) % 3;
  Planar_points base;
  for (Eigen::Index v = 0; v < surface.vertices.cols(); ++v)
    if (surface.vertices(axis, v) < base_height)
      base.emplace_back(surface.vertices(side, v), surface.vertices(front, v));
  const double stability = depth_inside({surface.centre[side], surface.centre[front]}, planar_hull(std::move(base)));
  return std::max(stability, least_stability) + weight_of_horizontal * surface.horizontal[axis];
}

} // namespace

Point estimate_up(const Segmented_shape& shape)
{
  CGAL_precondition(!shape.parts().empty());
  const Surface_summary surface = summary_of_surface(shape);
  int best = 1;
  for (int axis : {2, 0})
    if (quantized(uprightness(surface, axis)) > quantized(uprightness(surface, best))) best = axis;
  return Point::Unit(best);
}

} // namespace CGAL::Shape_correspondence

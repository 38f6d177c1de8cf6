// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_INTERNAL_MAP_PART_CUTTER_H
#define CGAL_SHAPE_CORRESPONDENCE_INTERNAL_MAP_PART_CUTTER_H

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Shape_correspondence/Segmented_shape.h>
#include <CGAL/Shape_correspondence/internal/map/Part_pair.h>
#include <CGAL/Shape_correspondence/internal/map/Subdivision.h>
#include <CGAL/Shape_correspondence/internal/planar_hull.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

/// How often directed sides run around a point of the plane, counter-clockwise.
inline double turns_around(const Eigen::Vector2d& p, const Planar_points& vertices,
                           const std::vector<std::array<int, 2>>& sides)
{
  double sum = 0;
  for (const auto& [a, b] : sides) {
    const Eigen::Vector2d u = vertices[std::size_t(a)] - p, v = vertices[std::size_t(b)] - p;
    sum += std::atan2(cross(u, v), u.dot(v));
  }
  return sum / (2 * EIGEN_PI);
}

/// The triangles that fill a section of a solid.
///
/// Vertices are numbered from 0 on; sides run around what they enclose counter-clockwise. Where sides cross each other,
/// which they do not if the solid's surface does not, all of them are joined to one more vertex.
inline std::vector<std::array<int, 3>> section_triangles(const Planar_points& vertices,
                                                         const std::vector<std::array<int, 2>>& sides)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Vertex = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
  using Structure = CGAL::Triangulation_data_structure_2<Vertex, CGAL::Constrained_triangulation_face_base_2<Kernel>>;
  using Triangulation =
      CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::No_constraint_intersection_tag>;
  std::vector<std::array<int, 3>> result;
  Triangulation triangulation;
  try {
    std::vector<Triangulation::Vertex_handle> handles;
    for (const Eigen::Vector2d& p : vertices) {
      handles.push_back(triangulation.insert({p.x(), p.y()}));
      handles.back()->info() = int(handles.size()) - 1;
    }
    if (triangulation.number_of_vertices() < vertices.size())
      throw Triangulation::Intersection_of_constraints_exception();
    for (const auto& [a, b] : sides)
      triangulation.insert_constraint(handles[std::size_t(a)], handles[std::size_t(b)]);
  } catch (const Triangulation::Intersection_of_constraints_exception&) {
    for (const auto& [a, b] : sides)
      result.push_back({a, b, int(vertices.size())});
    return result;
  }
  for (const auto& face : triangulation.finite_face_handles()) {
    std::array<int, 3> corners;
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    for (int i = 0; i < 3; ++i) {
      corners[std::size_t(i)] = face->vertex(i)->info();
      middle += vertices[std::size_t(corners[std::size_t(i)])] / 3;
    }
    const int turns = int(std::lround(turns_around(middle, vertices, sides)));
    if (turns < 0) std::swap(corners[0], corners[1]);
    result.insert(result.end(), std::size_t(std::abs(turns)), corners);
  }
  return result;
}

/// Cuts parts into pieces, one side of the piece after the other.
class Part_cutter
{
public:
  Part_cutter(const Points& points, const Eigen::Matrix3Xi& triangles, const Part_chart& chart)
      : chart_(chart), mesh_(points, triangles)
  {
    add_coordinates();
  }

  /// Removes what is beyond `at` in a coordinate and fills the section. Of a part all of which is beyond, the nearest
  /// point is left.
  void cut(int axis, double at, bool is_low)
  {
    const auto beyond = [&](int i) {
      const double beyond_at = coordinates_[std::size_t(i)][axis] - at;
      return is_low ? -beyond_at : beyond_at;
    };
    mesh_.split_edges([&](int a, int b) {
      const double x = beyond(a), y = beyond(b);
      return x * y < 0 && std::abs(x) > on_side && std::abs(y) > on_side ? x / (x - y) : -1;
    });
    for (std::size_t i = add_coordinates(); i < coordinates_.size(); ++i)
      coordinates_[i][axis] = at;
    int nearest = mesh_.corners(0)[0];
    for (std::size_t t = 0; t < mesh_.number_of_triangles(); ++t)
      for (int corner : mesh_.corners(t))
        if (beyond(corner) < beyond(nearest)) nearest = corner;
    mesh_.remove_triangles_if([&](const std::array<int, 3>& corners) {
      return std::all_of(corners.begin(), corners.end(), [&](int corner) { return beyond(corner) >= -on_side; });
    });
    if (mesh_.number_of_triangles() == 0)
      mesh_.add_triangle({nearest, nearest, nearest});
    else
      fill_section(axis, [&](int i) { return beyond(i) >= -on_side; });
  }

  /// What is left.
  Part_mesh mesh() const
  {
    const Points points = mesh_.points();
    Part_mesh result{Points(3, points.cols()), mesh_.triangles()};
    std::vector<int> number(std::size_t(points.cols()), -1);
    int count = 0;
    for (Eigen::Index t = 0; t < result.triangles.cols(); ++t)
      for (int& corner : result.triangles.col(t)) {
        int& own = number[std::size_t(corner)];
        if (own < 0) {
          own = count++;
          result.points.col(own) = points.col(corner);
        }
        corner = own;
      }
    result.points.conservativeResize(3, count);
    return result;
  }

private:
  static constexpr double on_side = 1e-9;

  /// Returns the number of those that there were.
  std::size_t add_coordinates()
  {
    const std::size_t before = coordinates_.size();
    for (std::size_t i = before; i < mesh_.number_of_points(); ++i)
      coordinates_.push_back(chart_.coordinates(mesh_.point(int(i))));
    return before;
  }

  template <typename Is_on_side>
  void fill_section(int axis, const Is_on_side& is_on_side)
  {
    std::vector<int> points; // by vertex of the section
    std::map<int, int> vertex;
    const auto number = [&](int point) {
      const auto [known, is_new] = vertex.try_emplace(point, int(points.size()));
      if (is_new) points.push_back(point);
      return known->second;
    };
    std::vector<std::array<int, 2>> sides;
    for (std::size_t t = 0; t < mesh_.number_of_triangles(); ++t)
      for (std::size_t i = 0; i < 3; ++i) {
        const int a = mesh_.corners(t)[i], b = mesh_.corners(t)[(i + 1) % 3];
        if (is_on_side(a) && is_on_side(b)) sides.push_back({number(b), number(a)});
      }
    if (sides.empty()) return;
    Planar_points vertices;
    Point middle = Point::Zero();
    for (int point : points) {
      const Point& k = coordinates_[std::size_t(point)];
      vertices.emplace_back(k[(axis + 1) % 3], k[(axis + 2) % 3]);
      middle += mesh_.point(point) / double(points.size());
    }
    points.push_back(mesh_.add_point(middle));
    for (const std::array<int, 3>& t : section_triangles(vertices, sides))
      mesh_.add_triangle({points[std::size_t(t[0])], points[std::size_t(t[1])], points[std::size_t(t[2])]});
    add_coordinates();
  }

  const Part_chart& chart_;
  Subdivision mesh_;
  std::vector<Point> coordinates_; ///< by point
};

/// The piece of a part that a box of its chart cuts out, closed if the part is. All of it for the whole chart.
inline Part_mesh piece_of(const Points& points, const Eigen::Matrix3Xi& triangles, const Part_chart& chart,
                          const Chart_box& box)
{
  if (is_whole(box)) return {points, triangles};
  Part_cutter cutter(points, triangles, chart);
  for (int axis = 0; axis < 3; ++axis) {
    if (box.min()[axis] > -1) cutter.cut(axis, box.min()[axis], true);
    if (box.max()[axis] < 1) cutter.cut(axis, box.max()[axis], false);
  }
  return cutter.mesh();
}

} // namespace internal
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_INTERNAL_MAP_PART_CUTTER_H

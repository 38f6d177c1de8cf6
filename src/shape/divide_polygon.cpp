// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "shape/divide_polygon.h"
#include "base/library_call.h"
#include "shape/meshes.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL::Shape_correspondence::internal {
namespace {

enum class Side { UNKNOWN, INSIDE, OUTSIDE };

using Planar_triangulation = CGAL::Constrained_Delaunay_triangulation_2<
    Mesh_kernel,
    CGAL::Triangulation_data_structure_2<
        CGAL::Triangulation_vertex_base_with_info_2<int, Mesh_kernel>,
        CGAL::Triangulation_face_base_with_info_2<Side, Mesh_kernel,
                                                  CGAL::Constrained_triangulation_face_base_2<Mesh_kernel>>>,
    CGAL::No_constraint_intersection_requiring_constructions_tag>;

int after(const std::vector<Link>& border, int v)
{
  const auto found = std::lower_bound(border.begin(), border.end(), Link{v, 0});
  return found == border.end() || (*found)[0] != v ? -1 : (*found)[1];
}

/// The triangles of a polygon of three or four edges. Of two possible diagonals, it takes the Delaunay edge; empty if
/// neither is possible.
std::vector<Corners> few_triangles(const std::vector<Point>& points, const std::vector<Link>& border,
                                   const Point& normal, const Eigen::Matrix3d& stretch)
{
  const int a = border[0][0], b = border[0][1], c = after(border, b), d = c < 0 ? -1 : after(border, c);
  if (d < 0) return {};
  if (border.size() == 3) return d == a ? std::vector<Corners>{{a, b, c}} : std::vector<Corners>();
  if (d == a || after(border, d) != a) return {};
  const auto between = [&](int from, int to) { return Point(points[std::size_t(to)] - points[std::size_t(from)]); };
  const auto is_upright = [&](int p, int q, int r) { return between(p, q).cross(between(p, r)).dot(normal) > 0; };
  const bool may_join_ac = is_upright(a, b, c) && is_upright(a, c, d),
             may_join_bd = is_upright(b, c, d) && is_upright(b, d, a);
  if (!may_join_ac && !may_join_bd) return {};
  const auto angle = [&](int at, int p, int q) {
    const Point u = stretch * between(at, p), v = stretch * between(at, q);
    return std::atan2(u.cross(v).norm(), u.dot(v));
  };
  const bool joins_ac =
      may_join_ac && (!may_join_bd || angle(b, a, c) + angle(d, a, c) <= angle(a, b, d) + angle(c, b, d));
  return joins_ac ? std::vector<Corners>{{a, b, c}, {a, c, d}} : std::vector<Corners>{{b, c, d}, {b, d, a}};
}

/// The triangles inside the border: those from which any path to the outside crosses it an odd number of times; empty
/// if that differs between paths.
std::vector<Corners> inside_of(const Planar_triangulation& triangulation)
{
  std::vector<Planar_triangulation::Face_handle> front{triangulation.infinite_face()};
  front.back()->info() = Side::OUTSIDE;
  std::vector<Corners> result;
  while (!front.empty()) {
    const auto face = front.back();
    front.pop_back();
    if (face->info() == Side::INSIDE)
      result.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
    for (int k = 0; k < 3; ++k) {
      const auto next = face->neighbor(k);
      const bool is_inside = (face->info() == Side::INSIDE) != face->is_constrained(k);
      const Side side = is_inside ? Side::INSIDE : Side::OUTSIDE;
      if (next->info() == Side::UNKNOWN) {
        next->info() = side;
        front.push_back(next);
      } else if (next->info() != side) {
        return {}; // the border has a gap
      }
    }
  }
  return result;
}

/// The triangles of a constrained Delaunay triangulation inside the border. CGAL throws if its edges cross.
std::vector<Corners> triangulated(const std::vector<Point>& points, const std::vector<Link>& border,
                                  const std::vector<int>& within, const Point& normal, const Eigen::Matrix3d& stretch)
{
  const Point up = (stretch.inverse().transpose() * normal).normalized(), u = up.unitOrthogonal(), v = up.cross(u);
  std::vector<int> vertices = within;
  for (const Link& link : border)
    vertices.insert(vertices.end(), link.begin(), link.end());
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  Planar_triangulation triangulation;
  std::vector<Planar_triangulation::Vertex_handle> handles;
  for (int vertex : vertices) {
    const Point p = stretch * (points[std::size_t(vertex)] - points[std::size_t(border[0][0])]);
    const auto near = handles.empty() ? Planar_triangulation::Face_handle() : handles.back()->face();
    handles.push_back(triangulation.insert({p.dot(u), p.dot(v)}, near));
    if (triangulation.number_of_vertices() < handles.size()) return {}; // two vertices in one place
    handles.back()->info() = vertex;
  }
  const auto handle_of = [&](int vertex) {
    return handles[std::size_t(std::lower_bound(vertices.begin(), vertices.end(), vertex) - vertices.begin())];
  };
  for (const Link& link : border)
    triangulation.insert_constraint(handle_of(link[0]), handle_of(link[1]));
  for (auto face : triangulation.all_face_handles())
    face->info() = Side::UNKNOWN;
  return triangulation.dimension() < 2 ? std::vector<Corners>() : inside_of(triangulation);
}

} // namespace

std::vector<Corners> divide_polygon(const std::vector<Point>& points, const std::vector<Link>& border,
                                    const std::vector<int>& within, const Point& normal, const Eigen::Matrix3d& stretch)
{
  if (border.size() < 3) return {};
  if (border.size() < 5) {
    std::vector<Corners> result = few_triangles(points, border, normal, stretch);
    if (!result.empty()) return result;
  }
  return library_call(
      "flat face", [&] { return triangulated(points, border, within, normal, stretch); },
      [] { return std::vector<Corners>(); });
}

} // namespace CGAL::Shape_correspondence::internal

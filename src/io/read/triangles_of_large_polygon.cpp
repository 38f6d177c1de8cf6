// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read/model_parts.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <Eigen/Geometry>

#include <optional>
#include <utility>

namespace CGAL::Shape_correspondence::IO {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Kernel>;
using Face = CGAL::Triangulation_face_base_with_info_2<std::optional<bool>, Kernel,
                                                       CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex, Face>,
                                               CGAL::No_constraint_intersection_tag>;

/// Marks whether faces are inside of the polygon: every side that is crossed on the way from outside changes that.
void mark_inside(Triangulation& triangulation)
{
  std::vector<Triangulation::Face_handle> faces{triangulation.infinite_face()};
  faces[0]->info() = false;
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (int i = 0; i < 3; ++i) {
      const Triangulation::Face_handle next = faces[f]->neighbor(i);
      if (next->info()) continue;
      next->info() = *faces[f]->info() != faces[f]->is_constrained(i);
      faces.push_back(next);
    }
}

} // namespace

void add_halves(std::size_t first, std::size_t last, std::vector<std::size_t>& triangles)
{
  if (last - first < 2) return;
  const std::size_t middle = first + (last - first) / 2;
  triangles.insert(triangles.end(), {first, middle, last});
  add_halves(first, middle, triangles);
  add_halves(middle, last, triangles);
}

std::vector<std::size_t> triangles_in_plane(const std::vector<Point>& polygon, const Point& normal)
{
  const Point x = normal.unitOrthogonal(), y = normal.cross(x);
  std::vector<std::pair<Kernel::Point_2, std::size_t>> corners;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    corners.emplace_back(Kernel::Point_2(x.dot(polygon[i]), y.dot(polygon[i])), i);
  Triangulation triangulation;
  triangulation.insert(corners.begin(), corners.end()); // in spatial order
  std::vector<std::size_t> result;
  if (triangulation.number_of_vertices() != polygon.size()) return result;
  std::vector<Triangulation::Vertex_handle> vertices(polygon.size());
  for (const auto vertex : triangulation.finite_vertex_handles())
    vertices[vertex->info()] = vertex;
  try {
    for (std::size_t i = 0; i < polygon.size(); ++i)
      triangulation.insert_constraint(vertices[i], vertices[(i + 1) % polygon.size()]);
  } catch (const Triangulation::Intersection_of_constraints_exception&) {
    return result;
  }
  mark_inside(triangulation);
  for (const auto face : triangulation.finite_face_handles())
    if (*face->info())
      for (int i = 0; i < 3; ++i)
        result.push_back(face->vertex(i)->info());
  return result;
}

} // namespace CGAL::Shape_correspondence::IO

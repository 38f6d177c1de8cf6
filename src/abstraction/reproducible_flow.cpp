// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "abstraction/reproducible_flow.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/eigen.hpp>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::internal {
namespace {

using Flow_vertex = boost::graph_traits<Flow_mesh>::vertex_descriptor;
using Delaunay_vertex = CGAL::Triangulation_vertex_base_with_info_3<Flow_vertex, Mesh_kernel>;
using Delaunay_cell = CGAL::Delaunay_triangulation_cell_base_3<Mesh_kernel>;
using Delaunay =
    CGAL::Delaunay_triangulation_3<Mesh_kernel, CGAL::Triangulation_data_structure_3<Delaunay_vertex, Delaunay_cell>>;

/// The circumcentre of a cell, computed from the edges at one corner (a, b, c); none if their volume is less than
/// `flattest` times that of a box with such edges.
template <typename Number>
std::optional<Point> circumcentre(const Delaunay::Cell& cell, double flattest)
{
  using Vector = Eigen::Matrix<Number, 3, 1>;
  const auto corner = [&](int i) -> Vector { return to_point(cell.vertex(i)->point()).template cast<Number>(); };
  const Vector p = corner(0), a = corner(1) - p, b = corner(2) - p, c = corner(3) - p;
  const Vector b_c = b.cross(c);
  const Number volume = a.dot(b_c), aa = a.dot(a), bb = b.dot(b), cc = c.dot(c);
  if (!(volume * volume > flattest * flattest * aa * bb * cc)) return {};
  const Vector result = p + (aa * b_c + bb * c.cross(a) + cc * a.cross(b)) / (2 * volume);
  return Point(result.template cast<double>());
}

/// The circumcentre, bitwise equal on all machines: by IEEE rounding, or with longer numbers where double is too short.
Point circumcentre(const Delaunay::Cell& cell)
{
  using Long_number = boost::multiprecision::cpp_bin_float_100;
  constexpr double flattest = 1e-6; // relative volume at which half of the digits are lost
  if (const std::optional<Point> result = circumcentre<double>(cell, flattest)) return *result;
  return circumcentre<Long_number>(cell, 0).value_or(to_point(cell.vertex(0)->point()));
}

/// Half of the cotangent of an angle in a triangle; 0 if negative, bounded for angles near 0. With CGAL's vectors,
/// since Eigen adds the products of the coordinates in another order.
double half_cotangent(const Mesh_kernel::Vector_3& side, const Mesh_kernel::Vector_3& other)
{
  constexpr double greatest_cosine = 0.999;
  const double along = side * other / std::sqrt(side.squared_length()) / std::sqrt(other.squared_length());
  if (!(along > 0)) return 0; // the angle may be undefined
  const double cosine = std::min(along, greatest_cosine);
  return cosine / std::sqrt(1 - cosine * cosine) / 2;
}

} // namespace
} // namespace CGAL::Shape_correspondence::internal

namespace CGAL {

template <>
void Mean_curvature_flow_skeletonization<Shape_correspondence::internal::Halfedge_mesh,
                                         Shape_correspondence::internal::Flow_traits>::compute_edge_weight()
{
  const auto weight_in_face = [&](halfedge_descriptor h) {
    const auto& apex = target(next(h, m_tmesh), m_tmesh)->point();
    return Shape_correspondence::internal::half_cotangent(source(h, m_tmesh)->point() - apex,
                                                          target(h, m_tmesh)->point() - apex);
  };
  m_edge_weight.clear();
  for (halfedge_descriptor h : halfedges(m_tmesh))
    m_edge_weight.push_back(weight_in_face(h) + weight_in_face(opposite(h, m_tmesh)));
}

template <>
void Mean_curvature_flow_skeletonization<Shape_correspondence::internal::Halfedge_mesh,
                                         Shape_correspondence::internal::Flow_traits>::compute_voronoi_pole()
{
  namespace internal = Shape_correspondence::internal;
  using Vector = Shape_correspondence::Point; // since Point is the mesh's type here
  compute_vertex_normal();
  std::vector<std::pair<internal::Mesh_point, vertex_descriptor>> points;
  for (auto v : vertices(m_tmesh))
    points.emplace_back(v->point(), v);
  const internal::Delaunay triangulation(points.begin(), points.end());

  // The pole is the circumcentre deepest below the vertex.
  std::vector<double> deepest(points.size(), 0);
  std::vector<Vector> poles(points.size());
  for (auto cell : triangulation.finite_cell_handles()) {
    const Vector centre = internal::circumcentre(*cell);
    for (int i = 0; i < 4; ++i) {
      const vertex_descriptor v = cell->vertex(i)->info();
      const auto& n = m_normals[v->id()];
      const double height = (centre - internal::to_point(v->point())).dot(Vector(n.x(), n.y(), n.z()));
      if (height >= deepest[v->id()]) continue;
      deepest[v->id()] = height;
      poles[v->id()] = centre;
    }
  }
  // The triangulation has only one of several vertices at the same point.
  for (const auto& [point, v] : points) {
    std::size_t known = v->id();
    if (deepest[known] == 0) {
      internal::Delaunay::Locate_type type;
      int i, j;
      const auto cell = triangulation.locate(point, type, i, j);
      known = cell->vertex(i)->info()->id();
    }
    if (deepest[known] < 0) v->pole = internal::to_mesh_point(poles[known]);
  }
  m_are_poles_computed = true;
}

template <>
auto Mean_curvature_flow_skeletonization<
    Shape_correspondence::internal::Halfedge_mesh,
    Shape_correspondence::internal::Flow_traits>::project_vertex(vertex_descriptor from, vertex_descriptor to,
                                                                 vertex_descriptor apex, vertex_descriptor added)
    -> Point
{
  added->is_fixed = from->is_fixed;
  Vector along = to->point() - from->point(), between_poles = to->pole - from->pole;
  normalize(along);
  normalize(between_poles);
  const double distance = along * (apex->point() - from->point());
  added->pole = from->pole + between_poles * distance;
  return from->point() + along * distance;
}

} // namespace CGAL

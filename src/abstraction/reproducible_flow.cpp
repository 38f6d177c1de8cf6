// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "abstraction/reproducible_flow.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <boost/multiprecision/cpp_int.hpp>

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::internal {
namespace {

using Flow_vertex = boost::graph_traits<Flow_mesh>::vertex_descriptor;
using Delaunay_vertex = CGAL::Triangulation_vertex_base_with_info_3<Flow_vertex, Mesh_kernel>;
using Delaunay_cell = CGAL::Delaunay_triangulation_cell_base_3<Mesh_kernel>;
using Delaunay =
    CGAL::Delaunay_triangulation_3<Mesh_kernel, CGAL::Triangulation_data_structure_3<Delaunay_vertex, Delaunay_cell>>;

/// By Cramer's rule, relative to a corner.
Point exact_circumcentre(const Delaunay::Cell& cell)
{
  using Number = boost::multiprecision::cpp_rational; // rounds alike everywhere, unlike the numbers of GMP
  using Vector = std::array<Number, 3>;
  const auto corner = [&](int i) -> Vector {
    const Mesh_point& p = cell.vertex(i)->point();
    return {Number(p.x()), Number(p.y()), Number(p.z())};
  };
  const auto from_to = [](const Vector& p, const Vector& q) -> Vector {
    return {q[0] - p[0], q[1] - p[1], q[2] - p[2]};
  };
  const auto dot = [](const Vector& u, const Vector& v) -> Number { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; };
  const auto cross = [](const Vector& u, const Vector& v) -> Vector {
    return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  };
  const Vector p = corner(0), a = from_to(p, corner(1)), b = from_to(p, corner(2)), c = from_to(p, corner(3));
  const Vector b_c = cross(b, c), c_a = cross(c, a), a_b = cross(a, b);
  const Number aa = dot(a, a), bb = dot(b, b), cc = dot(c, c), twice = 2 * dot(a, b_c);
  Point result;
  for (std::size_t i = 0; i < 3; ++i)
    result[Eigen::Index(i)] = Number(p[i] + (aa * b_c[i] + bb * c_a[i] + cc * a_b[i]) / twice).convert_to<double>();
  return result;
}

/// Equal on all machines: floating-point operations rounded to nearest, and exact ones where those are not enough.
Point circumcentre(const Delaunay::Cell& cell)
{
  const double flattest = 1e-6; // loses half of the digits
  const Point p = to_point(cell.vertex(0)->point());
  const Point a = to_point(cell.vertex(1)->point()) - p;
  const Point b = to_point(cell.vertex(2)->point()) - p;
  const Point c = to_point(cell.vertex(3)->point()) - p;
  const double aa = a.squaredNorm(), bb = b.squaredNorm(), cc = c.squaredNorm();
  const Point b_c = b.cross(c);
  const double volume = a.dot(b_c);
  if (!(std::abs(volume) > flattest * std::sqrt(aa * bb * cc))) return exact_circumcentre(cell);
  return p + (aa * b_c + bb * c.cross(a) + cc * a.cross(b)) / (2 * volume);
}

} // namespace
} // namespace CGAL::Shape_correspondence::internal

namespace CGAL {

template <>
void Mean_curvature_flow_skeletonization<Shape_correspondence::internal::Halfedge_mesh,
                                         Shape_correspondence::internal::Flow_traits>::compute_voronoi_pole()
{
  namespace internal = Shape_correspondence::internal;
  using Vector = Shape_correspondence::Point; // Point is the mesh's
  compute_vertex_normal();
  std::vector<std::pair<internal::Mesh_point, vertex_descriptor>> points;
  for (auto v : vertices(m_tmesh))
    points.emplace_back(v->point(), v);
  const internal::Delaunay triangulation(points.begin(), points.end());

  // The pole is the centre that lies deepest below the vertex.
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
  // Of vertices at one point, the triangulation has one.
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

} // namespace CGAL

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "shape/convex_hull_mesh.h"

#include <CGAL/Convex_hull_traits_3.h>
#include <CGAL/convex_hull_3.h>

#include <functional>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// Makes the hull's traits, and so the triangulation inside the hull algorithm, types of our own.
struct Hull_mesh_tag;

using Hull_traits = CGAL::Convex_hull_traits_3<Mesh_kernel, Hull_mesh_tag, CGAL::Tag_true>;
using Hull_triangulation =
    CGAL::Triangulation_data_structure_2<CGAL::Convex_hull_vertex_base_2<CGAL::GT3_for_CH3<Hull_traits>>,
                                         CGAL::Convex_hull_face_base_2<Hull_traits>>;

} // namespace CGAL::Shape_correspondence::internal

/// The hull algorithm goes round the border of what a point sees from the first vertex in a `std::map`. By default that
/// is the one of the lowest address, and the order of the hull's vertices and faces differs from run to run.
template <>
struct std::less<CGAL::Shape_correspondence::internal::Hull_triangulation::Vertex_handle>
{
  using Vertex_handle = CGAL::Shape_correspondence::internal::Hull_triangulation::Vertex_handle;

  bool operator()(const Vertex_handle& a, const Vertex_handle& b) const { return a->point() < b->point(); }
};

namespace CGAL::Shape_correspondence::internal {

Halfedge_mesh convex_hull_mesh(const Points& points)
{
  std::vector<Mesh_point> input;
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    input.push_back(to_mesh_point(points.col(i)));
  }
  Halfedge_mesh result;
  CGAL::convex_hull_3(input.begin(), input.end(), result, Hull_traits());
  return result;
}

} // namespace CGAL::Shape_correspondence::internal

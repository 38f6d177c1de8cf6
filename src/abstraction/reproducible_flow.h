// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

// Points are sorted for the Delaunay triangulation in the flow; what happens to ties must not depend on the standard
// library
#define CGAL_HILBERT_SORT_WITH_MEDIAN_POLICY_CROSS_PLATFORM_BEHAVIOR

#include "shape/meshes.h"

#include <CGAL/Mean_curvature_flow_skeletonization.h>

#include <functional>

namespace CGAL::Shape_correspondence::internal {

/// A kernel of our own, so that the mesh inside the flow has a type of our own, for which the order of its edges can be
/// defined.
struct Flow_traits : Mesh_kernel
{};

using Flow = CGAL::Mean_curvature_flow_skeletonization<Halfedge_mesh, Flow_traits>;
using Flow_mesh = Flow::Meso_skeleton;
using Flow_edge = boost::graph_traits<Flow_mesh>::edge_descriptor;

} // namespace CGAL::Shape_correspondence::internal

/// The flow collapses short edges in the order of a `std::set` of edges. In CGAL 5 that is the order of their
/// addresses, which differs from run to run, and so does the skeleton. The flow numbers all halfedges before each
/// collapse, in the order of its mesh; comparing numbers makes its result a function of the input. CGAL 6 compares
/// numbers itself, which gives the same order.
template <>
struct std::less<CGAL::Shape_correspondence::internal::Flow_edge>
{
  using Edge = CGAL::Shape_correspondence::internal::Flow_edge;

  bool operator()(const Edge& a, const Edge& b) const { return number(a) < number(b); }

private:
  // The two halfedges stand for one edge.
  static std::size_t number(const Edge& edge)
  {
    return (std::min)(edge.halfedge()->id(), edge.halfedge()->opposite()->id());
  }
};

namespace CGAL {

/// The library's own weights of edges are rounded in another way in CGAL 5 than in CGAL 6.
template <>
void Mean_curvature_flow_skeletonization<Shape_correspondence::internal::Halfedge_mesh,
                                         Shape_correspondence::internal::Flow_traits>::compute_edge_weight();

/// The library's own poles are midpoints of intervals, known to five digits, which depend on how the machine rounds;
/// the flow magnifies the difference. These are equal on all machines.
template <>
void Mean_curvature_flow_skeletonization<Shape_correspondence::internal::Halfedge_mesh,
                                         Shape_correspondence::internal::Flow_traits>::compute_voronoi_pole();

/// Where the vertex goes that splits an edge: to the foot of the apex's height; also gives it a pole. In CGAL 5, it is
/// a copy of the first end, and so as fixed as that; in CGAL 6, it would not be fixed.
template <>
auto Mean_curvature_flow_skeletonization<
    Shape_correspondence::internal::Halfedge_mesh,
    Shape_correspondence::internal::Flow_traits>::project_vertex(vertex_descriptor from, vertex_descriptor to,
                                                                 vertex_descriptor apex, vertex_descriptor added)
    -> Point;

} // namespace CGAL

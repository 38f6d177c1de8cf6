// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

// The flow sorts points for a Delaunay triangulation; how ties are resolved must not depend on the standard library
#define CGAL_HILBERT_SORT_WITH_MEDIAN_POLICY_CROSS_PLATFORM_BEHAVIOR

#include "shape/meshes.h"

#include <CGAL/Mean_curvature_flow_skeletonization.h>

#include <functional>

namespace CGAL::Shape_correspondence::internal {

/// A kernel type of our own makes the type of the mesh within the flow distinct, so that its edges can be ordered.
struct Flow_traits : Mesh_kernel
{};

using Flow = CGAL::Mean_curvature_flow_skeletonization<Halfedge_mesh, Flow_traits>;
using Flow_mesh = Flow::Meso_skeleton;
using Flow_edge = boost::graph_traits<Flow_mesh>::edge_descriptor;

} // namespace CGAL::Shape_correspondence::internal

/// The flow collapses short edges in the order of a `std::set` of edges, which is inside of its function. In CGAL 5
/// that is the order of their addresses, which makes the skeleton differ from run to run, and no other order can be
/// given. The flow numbers all halfedges before each collapse, in the order of its mesh; comparing the numbers makes
/// the result reproducible. CGAL 6 does so itself, in the same order.
template <>
struct std::less<CGAL::Shape_correspondence::internal::Flow_edge>
{
  using Edge = CGAL::Shape_correspondence::internal::Flow_edge;

  bool operator()(const Edge& a, const Edge& b) const { return number(a) < number(b); }

private:
  // The smaller index of the two halfedges of the edge.
  static std::size_t number(const Edge& edge)
  {
    return (std::min)(edge.halfedge()->id(), edge.halfedge()->opposite()->id());
  }
};

namespace CGAL {

/// The cotangent weights of edges. CGAL 5 and CGAL 6 would round them differently.
template <>
void Mean_curvature_flow_skeletonization<Shape_correspondence::internal::Halfedge_mesh,
                                         Shape_correspondence::internal::Flow_traits>::compute_edge_weight();

/// CGAL's own poles are midpoints of intervals, known to five digits, that depend on the rounding of the machine; the
/// flow magnifies the difference. These poles are equal on all machines.
template <>
void Mean_curvature_flow_skeletonization<Shape_correspondence::internal::Halfedge_mesh,
                                         Shape_correspondence::internal::Flow_traits>::compute_voronoi_pole();

/// The position of a vertex that splits an edge: the foot of the triangle's height from the apex. Sets the vertex's
/// pole, and copies whether the first end is fixed, as CGAL 5 does, unlike CGAL 6.
template <>
auto Mean_curvature_flow_skeletonization<
    Shape_correspondence::internal::Halfedge_mesh,
    Shape_correspondence::internal::Flow_traits>::project_vertex(vertex_descriptor from, vertex_descriptor to,
                                                                 vertex_descriptor apex, vertex_descriptor added)
    -> Point;

} // namespace CGAL

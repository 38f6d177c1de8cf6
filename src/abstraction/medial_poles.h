// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "abstraction/inside_test.h"
#include "abstraction/spatial_graph.h"
#include "base/Nearest_points.h"
#include "shape/oriented_box.h"
#include "shape/triangle_distance.h"

#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// Outward normals of vertices: the mean of their faces' normals, weighted by area.
inline Points vertex_normals(const Part_mesh& mesh)
{
  Points result = Points::Zero(3, mesh.points.cols());
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
    const Point normal = contacts::area_vector(triangle_of(mesh, t));
    for (int corner : mesh.triangles.col(t))
      result.col(corner) += normal;
  }
  result.colwise().normalize();
  return result;
}

/// The centre of the medial ball of a vertex, and the other vertex that the ball touches; -1: none.
struct Medial_pole
{
  Point centre;
  Eigen::Index touched = -1;
};

/// The centre of the largest ball that touches the surface in a vertex from inside and holds no other vertex: a point
/// of the medial axis. Computed by shrinking a large ball (Ma, Bae and Choi 2012).
/// \param likely a vertex that the ball probably touches, which saves time and only changes rounding; or -1
inline Medial_pole medial_pole(const Nearest_points& vertices, const Points& points, Eigen::Index v,
                               const Point& normal, double largest_radius, Eigen::Index likely)
{
  const int most_rounds = 30;
  const double clearly = 1e-6; // share of the radius by which a vertex must be inside the ball
  const Point p = points.col(v);
  const auto touching_radius = [&](Eigen::Index other) {
    const Point offset = p - points.col(other);
    return offset.squaredNorm() / (2 * normal.dot(offset));
  };
  double radius = largest_radius;
  Eigen::Index touched = -1;
  if (likely >= 0 && likely != v && normal.dot(p - points.col(likely)) > 0 && touching_radius(likely) < radius) {
    radius = touching_radius(likely);
    touched = likely;
  }
  for (int round = 0; round < most_rounds; ++round) {
    const Eigen::Index nearest = vertices.nearest_within(p - radius * normal, radius * (1 - clearly), v);
    if (nearest < 0) break;
    radius = touching_radius(nearest);
    touched = nearest;
  }
  return {p - radius * normal, touched};
}

/// For each vertex, an adjacent vertex of lower index; -1: none.
inline std::vector<Eigen::Index> earlier_neighbours(const Part_mesh& mesh)
{
  std::vector<Eigen::Index> result(std::size_t(mesh.points.cols()), -1);
  for (const auto& t : mesh.triangles.colwise()) {
    for (int k = 0; k < 3; ++k) {
      const int low = std::min(t[k], t[(k + 1) % 3]), high = std::max(t[k], t[(k + 1) % 3]);
      result[std::size_t(high)] = low;
    }
  }
  return result;
}

inline Points medial_poles(const Part_mesh& mesh)
{
  const Points normals = vertex_normals(mesh);
  const Nearest_points vertices(mesh.points);
  const double largest = diagonal(mesh.points);
  const std::vector<Eigen::Index> earlier = earlier_neighbours(mesh);
  std::vector<Eigen::Index> touched(earlier.size());
  Points result(3, mesh.points.cols());
  for (std::size_t v = 0; v < earlier.size(); ++v) {
    const auto i = Eigen::Index(v);
    const Eigen::Index likely = earlier[v] < 0 ? -1 : touched[std::size_t(earlier[v])];
    const Medial_pole pole = medial_pole(vertices, mesh.points, i, normals.col(i), largest, likely);
    result.col(i) = pole.centre;
    touched[v] = pole.touched;
  }
  return result;
}

/// The medial axis as sampled by the vertices: the edges of the mesh with every vertex moved to its pole. A vertex
/// whose pole is outside the mesh is not moved.
inline Spatial_graph medial_graph(const Part_mesh& mesh, const Points& poles)
{
  const Inside_test is_inside(mesh);
  Spatial_graph result = edge_graph(mesh);
  result.points = poles;
  for (Eigen::Index v = 0; v < mesh.points.cols(); ++v)
    if (!is_inside(result.points.col(v))) result.points.col(v) = mesh.points.col(v);
  return result;
}

} // namespace CGAL::Shape_correspondence::internal

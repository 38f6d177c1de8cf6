// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "abstraction/inside_test.h"
#include "abstraction/spatial_graph.h"
#include "base/Nearest_points.h"

#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <Eigen/Geometry>

#include <cmath>

namespace CGAL::Shape_correspondence::internal {

/// Normals of vertices, the mean of their faces' by area, pointing outwards.
inline Points vertex_normals(const Part_mesh& mesh)
{
  Points result = Points::Zero(3, mesh.points.cols());
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
    const Eigen::Vector3i v = mesh.triangles.col(t);
    const Point normal =
        (mesh.points.col(v[1]) - mesh.points.col(v[0])).cross(mesh.points.col(v[2]) - mesh.points.col(v[0]));
    for (int k = 0; k < 3; ++k) {
      result.col(v[k]) += normal;
    }
  }
  result.colwise().normalize();
  return result;
}

/// The centre of the largest ball that touches the surface in a vertex from inside and holds no other vertex: a point
/// of the medial axis. Found by shrinking a large ball (Ma, Bae and Choi 2012).
inline Point medial_pole(const Nearest_points& vertices, const Points& points, Eigen::Index v, const Point& normal,
                         double largest_radius)
{
  const int most_rounds = 30;
  const double clearly = 1e-6;
  const Point p = points.col(v);
  double radius = largest_radius;
  for (int round = 0; round < most_rounds; ++round) {
    const Point centre = p - radius * normal;
    const Eigen::Index nearest = vertices.nearest_within(centre, radius * (1 - clearly), v);
    if (nearest < 0) {
      break;
    }
    const Point offset = p - points.col(nearest);
    radius = offset.squaredNorm() / (2 * normal.dot(offset));
  }
  return p - radius * normal;
}

/// Medial poles of all vertices.
inline Points medial_poles(const Part_mesh& mesh)
{
  const Points normals = vertex_normals(mesh);
  const Nearest_points vertices(mesh.points);
  const double diagonal = (mesh.points.rowwise().maxCoeff() - mesh.points.rowwise().minCoeff()).norm();
  Points result(3, mesh.points.cols());
  for (Eigen::Index v = 0; v < mesh.points.cols(); ++v) {
    result.col(v) = medial_pole(vertices, mesh.points, v, normals.col(v), diagonal);
  }
  return result;
}

/// The medial axis as far as the vertices see it: each moved to its pole, the mesh's edges in between. A vertex whose
/// pole is not inside stays where it is.
inline Spatial_graph medial_graph(const Part_mesh& mesh, const Points& poles)
{
  const Inside_test is_inside(mesh);
  Spatial_graph result = edge_graph(mesh);
  result.points = poles;
  for (Eigen::Index v = 0; v < mesh.points.cols(); ++v) {
    if (!is_inside(result.points.col(v))) {
      result.points.col(v) = mesh.points.col(v);
    }
  }
  return result;
}

} // namespace CGAL::Shape_correspondence::internal

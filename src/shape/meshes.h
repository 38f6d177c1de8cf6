// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_SHAPE_MESHES_H
#define CGAL_SHAPE_CORRESPONDENCE_SHAPE_MESHES_H

#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/iterator.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

using Mesh_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh_point = Mesh_kernel::Point_3;
using Halfedge_mesh = CGAL::Surface_mesh<Mesh_point>;

inline Point to_point(const Mesh_point& p) { return {p.x(), p.y(), p.z()}; }
inline Mesh_point to_mesh_point(const Point& p) { return {p.x(), p.y(), p.z()}; }

inline double diagonal(const Halfedge_mesh& mesh)
{
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  return std::sqrt(CGAL::square(box.xmax() - box.xmin()) + CGAL::square(box.ymax() - box.ymin()) +
                   CGAL::square(box.zmax() - box.zmin()));
}

/// Triangles as ranges, which is what the polygon soup functions take.
struct Triangle_soup
{
  std::vector<Mesh_point> points;
  std::vector<std::vector<std::size_t>> triangles;
};

inline Triangle_soup to_soup(const Part_mesh& mesh)
{
  Triangle_soup result;
  for (Eigen::Index v = 0; v < mesh.points.cols(); ++v) {
    result.points.push_back(to_mesh_point(mesh.points.col(v)));
  }
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
    const auto corner = [&](int k) { return static_cast<std::size_t>(mesh.triangles(k, t)); };
    result.triangles.push_back({corner(0), corner(1), corner(2)});
  }
  return result;
}

/// \pre `mesh` has no garbage
inline Part_mesh to_part_mesh(const Halfedge_mesh& mesh)
{
  Part_mesh result;
  result.points.resize(3, static_cast<Eigen::Index>(mesh.number_of_vertices()));
  result.triangles.resize(3, static_cast<Eigen::Index>(mesh.number_of_faces()));
  for (auto v : mesh.vertices()) {
    result.points.col(static_cast<Eigen::Index>(v.idx())) = to_point(mesh.point(v));
  }
  for (auto f : mesh.faces()) {
    int k = 0;
    for (auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh)) {
      result.triangles(k++, static_cast<Eigen::Index>(f.idx())) = static_cast<int>(v.idx());
    }
  }
  return result;
}

/// \pre the triangles make a manifold, consistently oriented
inline Halfedge_mesh to_halfedge_mesh(const Part_mesh& mesh)
{
  Halfedge_mesh result;
  for (Eigen::Index v = 0; v < mesh.points.cols(); ++v) {
    result.add_vertex(to_mesh_point(mesh.points.col(v)));
  }
  const auto vertex = [](int v) { return Halfedge_mesh::Vertex_index(static_cast<Halfedge_mesh::size_type>(v)); };
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
    result.add_face(vertex(mesh.triangles(0, t)), vertex(mesh.triangles(1, t)), vertex(mesh.triangles(2, t)));
  }
  return result;
}

} // namespace internal
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_SHAPE_MESHES_H

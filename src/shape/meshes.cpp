// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "shape/meshes.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>

namespace CGAL::Shape_correspondence::internal {

Triangle_soup to_soup(const Part_mesh& mesh)
{
  Triangle_soup result;
  for (Eigen::Index v = 0; v < mesh.points.cols(); ++v)
    result.points.push_back(to_mesh_point(mesh.points.col(v)));
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
    const auto corner = [&](int k) { return std::size_t(mesh.triangles(k, t)); };
    result.triangles.push_back({corner(0), corner(1), corner(2)});
  }
  return result;
}

Part_mesh joined(const std::vector<const Part_mesh*>& meshes)
{
  Eigen::Index points = 0, triangles = 0;
  for (const Part_mesh* mesh : meshes) {
    points += mesh->points.cols();
    triangles += mesh->triangles.cols();
  }
  Part_mesh result;
  result.points.resize(3, points);
  result.triangles.resize(3, triangles);
  points = triangles = 0;
  for (const Part_mesh* mesh : meshes) {
    result.points.middleCols(points, mesh->points.cols()) = mesh->points;
    result.triangles.middleCols(triangles, mesh->triangles.cols()) = mesh->triangles.array() + int(points);
    points += mesh->points.cols();
    triangles += mesh->triangles.cols();
  }
  return result;
}

Halfedge_mesh manifold_surface(const Part_mesh& mesh, bool* changed)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  Triangle_soup soup = to_soup(mesh);
  const std::size_t points = soup.points.size(), triangles = soup.triangles.size();
  PMP::repair_polygon_soup(soup.points, soup.triangles);
  const bool repaired = soup.points.size() != points || soup.triangles.size() != triangles;
  const bool oriented = PMP::orient_polygon_soup(soup.points, soup.triangles);
  if (changed) *changed = repaired || !oriented;
  Halfedge_mesh result;
  PMP::polygon_soup_to_polygon_mesh(soup.points, soup.triangles, result);
  return result;
}

Part_mesh to_part_mesh(const Halfedge_mesh& mesh)
{
  Part_mesh result;
  result.points.resize(3, Eigen::Index(mesh.number_of_vertices()));
  result.triangles.resize(3, Eigen::Index(mesh.number_of_faces()));
  for (auto v : mesh.vertices())
    result.points.col(Eigen::Index(v.idx())) = to_point(mesh.point(v));
  for (auto f : mesh.faces()) {
    int k = 0;
    for (auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
      result.triangles(k++, Eigen::Index(f.idx())) = int(v.idx());
  }
  return result;
}

Halfedge_mesh to_halfedge_mesh(const Part_mesh& mesh)
{
  Halfedge_mesh result;
  for (Eigen::Index v = 0; v < mesh.points.cols(); ++v)
    result.add_vertex(to_mesh_point(mesh.points.col(v)));
  const auto vertex = [](int v) { return Halfedge_mesh::Vertex_index(static_cast<Halfedge_mesh::size_type>(v)); };
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t)
    result.add_face(vertex(mesh.triangles(0, t)), vertex(mesh.triangles(1, t)), vertex(mesh.triangles(2, t)));
  return result;
}

} // namespace CGAL::Shape_correspondence::internal

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_INTERNAL_SEGMENTED_SHAPE_FROM_MESH_H
#define CGAL_SHAPE_CORRESPONDENCE_INTERNAL_SEGMENTED_SHAPE_FROM_MESH_H

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <map>
#include <utility>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

/// Collects faces of a mesh as an indexed triangle mesh that holds their vertices only; polygons become fans.
template <typename Mesh>
class Part_mesh_builder
{
  using vertex_descriptor = typename boost::graph_traits<Mesh>::vertex_descriptor;
  using face_descriptor = typename boost::graph_traits<Mesh>::face_descriptor;

public:
  explicit Part_mesh_builder(const Mesh& mesh) : mesh_(&mesh) {}

  void add_face(face_descriptor face)
  {
    std::vector<int> corners;
    for (vertex_descriptor v : CGAL::vertices_around_face(halfedge(face, *mesh_), *mesh_)) {
      corners.push_back(index_of(v));
    }
    for (std::size_t k = 2; k < corners.size(); ++k) {
      triangles_.emplace_back(corners[0], corners[k - 1], corners[k]);
    }
  }

  Part_mesh build() const
  {
    Part_mesh result;
    result.points.resize(3, static_cast<Eigen::Index>(points_.size()));
    result.triangles.resize(3, static_cast<Eigen::Index>(triangles_.size()));
    for (std::size_t v = 0; v < points_.size(); ++v) {
      result.points.col(static_cast<Eigen::Index>(v)) = points_[v];
    }
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      result.triangles.col(static_cast<Eigen::Index>(t)) = triangles_[t];
    }
    return result;
  }

private:
  int index_of(vertex_descriptor v)
  {
    const auto [position, is_new] = indices_.emplace(v, static_cast<int>(points_.size()));
    if (is_new) {
      const auto& p = get(get(CGAL::vertex_point, *mesh_), v);
      points_.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
    }
    return position->second;
  }

  const Mesh* mesh_;
  std::map<vertex_descriptor, int> indices_;
  std::vector<Point> points_;
  std::vector<Eigen::Vector3i> triangles_;
};

} // namespace internal

template <typename TriangleMesh>
void Segmented_shape::add_mesh(std::string name, const TriangleMesh& mesh)
{
  internal::Part_mesh_builder<TriangleMesh> builder(mesh);
  for (auto face : faces(mesh)) {
    builder.add_face(face);
  }
  add_part(std::move(name), builder.build());
}

template <typename NamedMeshRange>
Segmented_shape Segmented_shape::from_meshes(const NamedMeshRange& meshes, std::string name, const Point& up)
{
  Segmented_shape result(std::move(name), up);
  for (const auto& [part_name, mesh] : meshes) {
    result.add_mesh(part_name, mesh);
  }
  return result;
}

template <typename TriangleMesh, typename SegmentIdMap>
Segmented_shape Segmented_shape::from_segmentation(const TriangleMesh& mesh, SegmentIdMap segment_ids, std::string name,
                                                   const Point& up)
{
  using Builder = internal::Part_mesh_builder<TriangleMesh>;
  std::map<long long, Builder> segments;
  for (auto face : faces(mesh)) {
    segments.try_emplace(static_cast<long long>(get(segment_ids, face)), mesh).first->second.add_face(face);
  }
  if (segments.empty()) {
    throw Invalid_input("shape '" + name + "': the mesh has no faces; give a mesh with a surface");
  }
  Segmented_shape result(std::move(name), up);
  for (const auto& [id, builder] : segments) {
    result.add_part("segment_" + std::to_string(id), builder.build());
  }
  return result;
}

} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_INTERNAL_SEGMENTED_SHAPE_FROM_MESH_H

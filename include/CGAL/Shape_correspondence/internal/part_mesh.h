// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_INTERNAL_PART_MESH_H
#define CGAL_SHAPE_CORRESPONDENCE_INTERNAL_PART_MESH_H

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/Points.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <map>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL::Shape_correspondence {
namespace parameters {

/// Tag of the named parameter `part_names` (parameters.h).
struct part_names_t
{};

} // namespace parameters

namespace internal {

template <typename NamedParameters, typename Tag>
constexpr bool is_named = !CGAL::parameters::is_default_parameter<NamedParameters, Tag>::value;

/// The points of a mesh's vertices: the named parameter `vertex_point_map`, or the mesh's own map.
template <typename Mesh, typename NamedParameters>
auto vertex_point_map(const Mesh& mesh, const NamedParameters& np)
{
  if constexpr (is_named<NamedParameters, internal_np::vertex_point_t>)
    return CGAL::parameters::get_parameter(np, internal_np::vertex_point);
  else
    return get(CGAL::vertex_point, mesh);
}

/// The name of the part for a segment: from the named parameter `part_names`, or derived from the id.
template <typename NamedParameters>
std::string part_name(long long id, const NamedParameters& np)
{
  if constexpr (is_named<NamedParameters, parameters::part_names_t>) {
    const auto& names = CGAL::parameters::get_parameter_reference(np, parameters::part_names_t());
    try {
      return names.at(id);
    } catch (const std::out_of_range&) {
      throw Invalid_input("part_names has no name for segment " + std::to_string(id));
    }
  } else
    return "segment_" + std::to_string(id);
}

/// Collects points and polygons, which are triangulated as fans.
class Part_mesh_data
{
public:
  int add_point(double x, double y, double z);
  void add_polygon(const std::vector<int>& corners);

  Points points() const;
  Eigen::Matrix3Xi triangles() const;

private:
  std::vector<Point> points_;
  std::vector<Eigen::Vector3i> triangles_;
};

/// Collects faces of a mesh, with only the vertices of these faces.
template <typename Mesh>
class Part_mesh_builder
{
  using Traits = boost::graph_traits<Mesh>;

public:
  template <typename VertexPointMap>
  void add_face(typename Traits::face_descriptor face, const Mesh& mesh, const VertexPointMap& vertex_points)
  {
    std::vector<int> corners;
    for (auto v : CGAL::vertices_around_face(halfedge(face, mesh), mesh)) {
      const auto [position, is_new] = indices_.emplace(v, 0);
      if (is_new) {
        const auto& p = get(vertex_points, v);
        position->second = data_.add_point(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
      }
      corners.push_back(position->second);
    }
    data_.add_polygon(corners);
  }

  Points points() const { return data_.points(); }
  Eigen::Matrix3Xi triangles() const { return data_.triangles(); }

private:
  std::map<typename Traits::vertex_descriptor, int> indices_;
  Part_mesh_data data_;
};

/// The faces of each segment, by the segment's id. \param segment_of returns the id of a face's segment
template <typename Mesh, typename Function, typename VertexPointMap>
auto meshes_of_segments(const Mesh& mesh, const Function& segment_of, const VertexPointMap& vertex_points)
{
  std::map<long long, Part_mesh_builder<Mesh>> result;
  for (auto face : faces(mesh))
    result[static_cast<long long>(segment_of(face))].add_face(face, mesh, vertex_points);
  return result;
}

} // namespace internal
} // namespace CGAL::Shape_correspondence

#endif // CGAL_SHAPE_CORRESPONDENCE_INTERNAL_PART_MESH_H

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

/// Collects faces of a mesh as an indexed triangle mesh with only the vertices of these faces.
template <typename Mesh, typename VertexPointMap>
class Part_mesh_builder
{
  using vertex_descriptor = typename boost::graph_traits<Mesh>::vertex_descriptor;
  using face_descriptor = typename boost::graph_traits<Mesh>::face_descriptor;

public:
  Part_mesh_builder(const Mesh& mesh, const VertexPointMap& points) : mesh_(&mesh), vertex_points_(points) {}

  void add_face(face_descriptor face)
  {
    std::vector<int> corners;
    const auto first = halfedge(face, *mesh_);
    auto h = first;
    do {
      corners.push_back(index_of(target(h, *mesh_)));
      h = next(h, *mesh_);
    } while (h != first);
    data_.add_polygon(corners);
  }

  const Part_mesh_data& data() const { return data_; }

private:
  int index_of(vertex_descriptor v)
  {
    const auto [position, is_new] = indices_.emplace(v, 0);
    if (is_new) {
      const auto& p = get(vertex_points_, v);
      position->second = data_.add_point(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
    }
    return position->second;
  }

  const Mesh* mesh_;
  VertexPointMap vertex_points_;
  std::map<vertex_descriptor, int> indices_;
  Part_mesh_data data_;
};

} // namespace internal
} // namespace CGAL::Shape_correspondence

#endif // CGAL_SHAPE_CORRESPONDENCE_INTERNAL_PART_MESH_H

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/simplified_shape.h"
#include "shape/meshes.h"

#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <algorithm>

namespace CGAL::Shape_correspondence::IO {
namespace {

constexpr std::size_t fewest_triangles = 24; // of a part: two boxes

Part_mesh simplified_part(const Part_mesh& mesh, std::size_t most_triangles)
{
  if (std::size_t(mesh.triangles.cols()) <= most_triangles) return mesh;
  internal::Halfedge_mesh surface = internal::manifold_surface(mesh);
  const std::size_t edges = most_triangles * 3 / 2; // a closed surface has so many
  Surface_mesh_simplification::edge_collapse(
      surface, Surface_mesh_simplification::Count_stop_predicate<internal::Halfedge_mesh>(edges));
  surface.collect_garbage();
  return surface.number_of_faces() > 0 ? internal::to_part_mesh(surface) : mesh;
}

} // namespace

std::size_t number_of_triangles(const Segmented_shape& shape)
{
  std::size_t result = 0;
  for (const Shape_part& part : shape.parts())
    result += std::size_t(part.mesh.triangles.cols());
  return result;
}

Segmented_shape simplified_shape(const Segmented_shape& shape, std::size_t most_triangles)
{
  const std::size_t all = number_of_triangles(shape);
  if (all <= most_triangles) return shape;
  Segmented_shape result(shape.name(), shape.up());
  for (const Shape_part& part : shape.parts()) {
    const double share = double(part.mesh.triangles.cols()) / double(all);
    result.add_part(
        part.name, simplified_part(part.mesh, std::max(fewest_triangles, std::size_t(share * double(most_triangles)))));
  }
  return result;
}

} // namespace CGAL::Shape_correspondence::IO

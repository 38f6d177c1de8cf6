// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/library_call.h"
#include "io/write/pictures.h"
#include "shape/meshes.h"

#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_placement.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <Eigen/Geometry>

#include <algorithm>

namespace CGAL::Shape_correspondence::IO {
namespace {

constexpr std::size_t fewest_triangles = 24; // limit for a part: two boxes
constexpr double margin = 0.05;              // around the triangles at an edge, over the diagonal of their bounding box

/// The placement of Lindstrom and Turk, or the midpoint of the edge where that is far away, as on thin pieces, where
/// the planes that determine it nearly meet in a line.
class Near_placement
{
public:
  template <class Profile>
  auto operator()(const Profile& profile) const
  {
    auto place = anywhere_(profile);
    if (place && !box_of(profile).contains(internal::to_point(*place)))
      *place = CGAL::midpoint(profile.p0(), profile.p1());
    return place;
  }

private:
  /// The bounding box of the triangles at an edge, with a margin.
  template <class Profile>
  static Eigen::AlignedBox3d box_of(const Profile& profile)
  {
    Eigen::AlignedBox3d box(internal::to_point(profile.p0()));
    box.extend(internal::to_point(profile.p1()));
    for (const auto vertex : profile.link())
      box.extend(internal::to_point(get(profile.vertex_point_map(), vertex)));
    const Point side = Point::Constant(margin * box.diagonal().norm());
    return {box.min() - side, box.max() + side};
  }

  Surface_mesh_simplification::LindstromTurk_placement<internal::Halfedge_mesh> anywhere_;
};

/// Stops when few enough edges are left; the names of CGAL's own predicate differ between versions.
struct Edge_limit
{
  template <class Cost, class Profile>
  bool operator()(const Cost&, const Profile&, std::size_t, std::size_t edges) const
  {
    return edges < limit;
  }

  std::size_t limit;
};

Part_mesh collapsed(const Part_mesh& mesh, std::size_t most_triangles)
{
  internal::Halfedge_mesh surface = internal::manifold_surface(mesh);
  const std::size_t edges = most_triangles * 3 / 2; // exact for a closed surface
  Surface_mesh_simplification::edge_collapse(surface, Edge_limit{edges},
                                             CGAL::parameters::get_placement(Near_placement()));
  surface.collect_garbage();
  return surface.number_of_faces() > 0 ? internal::to_part_mesh(surface) : mesh;
}

Part_mesh simplified_part(const Part_mesh& mesh, std::size_t most_triangles)
{
  if (std::size_t(mesh.triangles.cols()) <= most_triangles) return mesh;
  return internal::library_call(
      "simplification", [&] { return collapsed(mesh, most_triangles); }, [&] { return mesh; });
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

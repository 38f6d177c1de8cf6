// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "shape/has_area.h"
#include "shape/meshes.h"

#include <CGAL/Shape_correspondence/segment_mesh.h>

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/mesh_segmentation.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence {
using namespace internal;

namespace {

// Triangles on a ray through a mesh up to which its thickness is measured.
constexpr double most_triangles_on_ray = 1000;

/// The number of triangles whose bounding boxes a random ray through that of the mesh meets, on average: the sum of
/// their areas over its area. Needles across the mesh make it large.
double triangles_on_ray(const Halfedge_mesh& mesh)
{
  const auto area = [](const CGAL::Bbox_3& box) {
    const double x = box.x_span(), y = box.y_span(), z = box.z_span();
    return x * y + y * z + z * x;
  };
  CGAL::Bbox_3 all;
  double sum = 0;
  for (const auto face : mesh.faces()) {
    const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::face_bbox(face, mesh);
    all += box;
    sum += area(box);
  }
  return sum / area(all);
}

/// Segment ids of a closed connected mesh, from 0 on; none where most triangles are needles across the mesh, so that
/// its thickness would take very long to measure, and where the shape diameter function is not finite, as on a
/// damaged mesh whose triangles differ in size by many orders of magnitude: its clustering would not end.
std::optional<std::vector<std::size_t>> sdf_segments(const Halfedge_mesh& mesh, const Segmentation_options& options)
{
  if (!(triangles_on_ray(mesh) <= most_triangles_on_ray)) return std::nullopt;
  std::vector<double> sdf(mesh.number_of_faces());
  std::vector<std::size_t> segments(mesh.number_of_faces());
  const auto id = CGAL::get(boost::face_index, mesh);
  const auto sdf_map = boost::make_iterator_property_map(sdf.begin(), id);
  const double greatest = CGAL::sdf_values(mesh, sdf_map).second;
  const bool is_measured = greatest < std::numeric_limits<double>::max() &&
                           std::all_of(sdf.begin(), sdf.end(), [](double value) { return std::isfinite(value); });
  if (!is_measured) return std::nullopt;
  CGAL::segmentation_from_sdf_values(mesh, sdf_map, boost::make_iterator_property_map(segments.begin(), id),
                                     std::size_t(options.clusters), options.smoothness);
  return segments;
}

} // namespace

Mesh_segmentation segment_mesh(const Part_mesh& mesh, const Segmentation_options& options, std::string name,
                               const Point& up)
{
  Halfedge_mesh surface = manifold_surface(mesh);
  std::vector<Halfedge_mesh> components;
  CGAL::Polygon_mesh_processing::split_connected_components(surface, components);
  Mesh_segmentation result{Segmented_shape(std::move(name), up)};
  for (Halfedge_mesh& component : components) {
    component.collect_garbage();
    if (!has_area(to_part_mesh(component))) {
      ++result.pieces_left_out;
      continue;
    }
    std::vector<std::size_t> segments(component.number_of_faces(), 0);
    if (CGAL::is_closed(component)) {
      CGAL::Polygon_mesh_processing::orient_to_bound_a_volume(component); // its inside is what is measured
      if (const auto found = sdf_segments(component, options))
        segments = *found;
      else
        ++result.pieces_kept_whole;
    }
    const Part_mesh_builder empty(component, component.points());
    std::map<std::size_t, std::decay_t<decltype(empty)>> builders;
    for (auto face : component.faces())
      builders.try_emplace(segments[face.idx()], empty).first->second.add_face(face);
    for (const auto& [segment, builder] : builders) {
      Part_mesh part{builder.data().points(), builder.data().triangles()};
      if (has_area(part))
        result.shape.add_part("segment_" + std::to_string(result.shape.parts().size()), std::move(part));
      else
        ++result.pieces_left_out;
    }
  }
  return result;
}

} // namespace CGAL::Shape_correspondence

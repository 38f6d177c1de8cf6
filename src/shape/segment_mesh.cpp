// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/library_call.h"
#include "shape/Flat_faces.h"
#include "shape/check_mesh.h"
#include "shape/convex_segments.h"
#include "shape/has_area.h"
#include "shape/meshes.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/segment_mesh.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence {
using namespace internal;

namespace {

/// The mesh with its vertices and triangles in an order that does not depend on the file.
Part_mesh in_order(const Part_mesh& mesh)
{
  const Sorted_triangles sorted(mesh);
  Part_mesh result;
  result.points.resize(3, Eigen::Index(sorted.points.size()));
  result.triangles.resize(3, Eigen::Index(sorted.triangles.size()));
  for (std::size_t v = 0; v < sorted.points.size(); ++v)
    result.points.col(Eigen::Index(v)) = sorted.points[v];
  for (std::size_t t = 0; t < sorted.triangles.size(); ++t)
    result.triangles.col(Eigen::Index(t)) = Eigen::Vector3i(sorted.triangles[t].data());
  return result;
}

/// The connected components of the manifold that the triangles make; none if CGAL fails. \param areas gets their areas
std::vector<Halfedge_mesh> components_of(const Part_mesh& mesh, std::vector<double>& areas)
{
  return library_call(
      "components",
      [&] {
        Halfedge_mesh surface = manifold_surface(in_order(mesh));
        std::vector<Halfedge_mesh> components;
        CGAL::Polygon_mesh_processing::split_connected_components(surface, components);
        for (Halfedge_mesh& component : components) {
          component.collect_garbage();
          areas.push_back(CGAL::to_double(CGAL::Polygon_mesh_processing::area(component)));
        }
        return components;
      },
      [] { return std::vector<Halfedge_mesh>(); });
}

/// For each face, the number of its segment; none if the component has no inside, or CGAL fails.
std::vector<std::size_t> segments_of(Halfedge_mesh& component, std::size_t patches, const Segmentation_options& options)
{
  return library_call(
      "segments",
      [&] {
        CGAL::Polygon_mesh_processing::orient_to_bound_a_volume(component); // its inside is what is measured
        return convex_segments(component, patches, options);
      },
      [] { return std::vector<std::size_t>(); });
}

} // namespace

Mesh_segmentation segment_mesh(const Part_mesh& mesh, const Segmentation_options& options, std::string name,
                               const Point& up)
{
  if (options.patches < 1) throw Invalid_input("the number of patches of a segmentation is 0; give at least 1");
  if (!(options.probability > 0 && options.probability < 1) || !(options.least_area >= 0 && options.least_area <= 1))
    throw Invalid_input("the probability and the least area of a segmentation must be between 0 and 1");
  check_triangles(name, mesh);
  std::vector<double> areas;
  std::vector<Halfedge_mesh> components = components_of(mesh, areas);
  const double total_area = std::accumulate(areas.begin(), areas.end(), 0.);
  Mesh_segmentation result{Segmented_shape(std::move(name), up)};
  if (components.empty() && has_area(mesh)) {
    result.shape.add_part("segment_0", mesh);
    ++result.pieces_kept_whole;
  }
  for (std::size_t i = 0; i < components.size(); ++i) {
    Halfedge_mesh& component = components[i];
    if (!has_area(to_part_mesh(component))) {
      ++result.pieces_left_out;
      continue;
    }
    std::vector<std::size_t> segments;
    if (CGAL::is_closed(component)) {
      // Fewer patches for small components: the time, quadratic in them, must not grow with the number of components
      const double patches = std::ceil(double(options.patches) * std::sqrt(areas[i] / total_area));
      const double most = double(component.number_of_faces());
      segments = segments_of(component, std::size_t(std::clamp(patches, 1., most)), options);
      if (segments.empty()) ++result.pieces_kept_whole;
    }
    segments.resize(component.number_of_faces(), 0);
    const auto meshes = meshes_of_segments(
        component, [&](auto face) { return segments[face.idx()]; }, component.points());
    for (const auto& [segment, mesh_of_segment] : meshes) {
      Part_mesh part{mesh_of_segment.points(), mesh_of_segment.triangles()};
      if (has_area(part))
        result.shape.add_part("segment_" + std::to_string(result.shape.parts().size()), std::move(part));
      else
        ++result.pieces_left_out;
    }
  }
  return result;
}

} // namespace CGAL::Shape_correspondence

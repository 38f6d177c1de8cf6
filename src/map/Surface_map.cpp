// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "map/Surface_pair.h"
#include "map/check_model.h"
#include "matching/check_correspondence.h"

#include <CGAL/Shape_correspondence/Surface_map.h>

#include <limits>

namespace CGAL::Shape_correspondence {
using namespace internal;

Surface_map::Surface_map(const Structural_graph& source, const Segmented_shape& source_shape,
                         const Structural_graph& target, const Segmented_shape& target_shape,
                         const Correspondence& correspondence)
{
  check_model(source, source_shape);
  check_model(target, target_shape);
  check_correspondence("Surface_map", correspondence, source_shape.parts().size(), target_shape.parts().size());
  const std::array<const Segmented_shape*, 2> shapes = {&source_shape, &target_shape};
  const std::array<Charted_shape, 2> charted = {
      charted_shape(source, 0, mesh_surfaces(source_shape)),
      charted_shape(target, correspondence.target_quarter_turns, mesh_surfaces(target_shape))};
  std::array<Places*, 2> places = {&targets_, &sources_}; // places of the vertices of the source and of the target
  // For each vertex, squared distance from the nearest piece so far
  std::array<std::vector<std::vector<double>>, 2> off;
  for (std::size_t s = 0; s < 2; ++s)
    for (const Shape_part& part : shapes[s]->parts()) {
      places[s]->emplace_back(std::size_t(part.mesh.points.cols()));
      off[s].emplace_back(std::size_t(part.mesh.points.cols()), std::numeric_limits<double>::infinity());
      if (s == 0) triangles_.push_back(part.mesh.triangles);
    }

  for (const Piece_pair& pair : piece_pairs(charted[0], charted[1], correspondence)) {
    const std::array<std::size_t, 2> part = {pair.source, pair.target};
    const std::array<Chart_box, 2> boxes = {pair.source_piece, pair.target_piece};
    const auto mesh = [&](std::size_t s) -> const Part_mesh& { return shapes[s]->parts()[part[s]].mesh; };
    const std::array<Charted_mesh, 2> whole = surface_pair(pair, charted, {&mesh(0), &mesh(1)}).meshes;
    const std::array<Points, 2> normals = {chart_normals(whole[0]), chart_normals(whole[1])};
    for (std::size_t s = 0; s < 2; ++s) {
      const std::size_t other = 1 - s;
      const Place_finder finder(whole[other].coordinates, whole[other].triangles, normals[other]);
      for (Eigen::Index v = 0; v < whole[s].points.cols(); ++v) {
        const Point k = charted[s].charts[part[s]].coordinates(whole[s].points.col(v));
        const double outside = is_whole(boxes[s]) ? 0 : boxes[s].squaredExteriorDistance(k);
        double& least = off[s][part[s]][std::size_t(v)];
        if (outside >= least) continue;
        least = outside;
        const Mesh_place found = finder(whole[s].coordinates.col(v), normals[s].col(v));
        (*places[s])[part[s]][std::size_t(v)] = Surface_place{part[other], found.triangle, found.weights,
                                                              found.of(mesh(other).points, mesh(other).triangles)};
      }
    }
  }
}

std::optional<Surface_place> Surface_map::place_of(const Places& places, std::size_t part, Eigen::Index vertex)
{
  check_index("Surface_map", "part", part, places.size());
  check_index("Surface_map", "vertex", std::size_t(vertex), places[part].size());
  return places[part][std::size_t(vertex)];
}

std::optional<Surface_place> Surface_map::source_of(std::size_t target_part, Eigen::Index vertex) const
{
  return place_of(sources_, target_part, vertex);
}

std::optional<Surface_place> Surface_map::target_of(std::size_t source_part, Eigen::Index vertex) const
{
  return place_of(targets_, source_part, vertex);
}

} // namespace CGAL::Shape_correspondence

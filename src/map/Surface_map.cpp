// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "map/Piece_pair.h"
#include "matching/check_correspondence.h"

#include <CGAL/Shape_correspondence/Surface_map.h>

#include <algorithm>
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

namespace CGAL::Shape_correspondence::internal {

Point_map::Point_map(const Structural_graph& source, const Segmented_shape& source_shape,
                     const Structural_graph& target, const Segmented_shape& target_shape,
                     const Correspondence& correspondence)
    : target_(charted_shape(target, correspondence.target_quarter_turns, mesh_surfaces(target_shape))),
      target_shape_(target_shape),
      pieces_(target_shape.parts().size())
{
  check_model(source, source_shape);
  check_model(target, target_shape);
  const std::array<Charted_shape, 2> charted = {charted_shape(source, 0, mesh_surfaces(source_shape)), target_};
  for (const Piece_pair& pair : piece_pairs(charted[0], charted[1], correspondence)) {
    auto piece = std::make_unique<Piece>(Piece{
        pair.source,
        pair.target_piece,
        surface_pair(pair, charted, {&source_shape.parts()[pair.source].mesh, &target_shape.parts()[pair.target].mesh}),
        {},
        nullptr});
    for (std::size_t s = 0; s < 2; ++s)
      piece->normals[s] = chart_normals(piece->surfaces.meshes[s]);
    piece->finder = std::make_unique<Place_finder>(piece->surfaces.meshes[0].coordinates,
                                                   piece->surfaces.meshes[0].triangles, piece->normals[0]);
    pieces_[pair.target].push_back(std::move(piece));
  }
}

std::vector<std::size_t> Point_map::sources(std::size_t target_part) const
{
  std::vector<std::size_t> result;
  for (const auto& piece : pieces_[target_part])
    if (std::find(result.begin(), result.end(), piece->source) == result.end()) result.push_back(piece->source);
  return result;
}

Part_place Point_map::operator()(std::size_t target_part, Eigen::Index triangle, const Eigen::Vector3d& weights) const
{
  const auto& pieces = pieces_[target_part];
  const Eigen::Matrix3Xi& triangles = target_shape_.parts()[target_part].mesh.triangles;
  const Mesh_place place{triangle, weights};
  const Point p = place.of(target_.surfaces[target_part], triangles);
  const Piece* piece = pieces[0].get();
  if (pieces.size() > 1) {
    const Point k = target_.charts[target_part].coordinates(p);
    const auto outside = [&](const auto& of) { return of->box.squaredExteriorDistance(k); };
    piece = std::min_element(pieces.begin(), pieces.end(), [&](const auto& a, const auto& b) {
              return outside(a) < outside(b);
            })->get();
  }
  const Mesh_place found =
      (*piece->finder)(piece->surfaces.charts.target.coordinates(p), place.of(piece->normals[1], triangles));
  return {piece->source, found.triangle, found.weights};
}

} // namespace CGAL::Shape_correspondence::internal

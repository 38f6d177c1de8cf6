// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "map/Point_map.h"
#include "map/check_model.h"

#include <algorithm>

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

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "map/Surface_pair.h"
#include "map/piece_of.h"

#include <limits>

namespace CGAL::Shape_correspondence::internal {

std::vector<const Points*> mesh_surfaces(const Segmented_shape& shape)
{
  std::vector<const Points*> result;
  for (const Shape_part& part : shape.parts())
    result.push_back(&part.mesh.points);
  return result;
}

Surface_pair surface_pair(const Piece_pair& pair, const std::array<Charted_shape, 2>& shapes,
                          const std::array<const Part_mesh*, 2>& meshes)
{
  constexpr double longest_edge = 0.3; // in chart coordinates
  const std::array<std::size_t, 2> part = {pair.source, pair.target};
  const std::array<Chart_box, 2> boxes = {pair.source_piece, pair.target_piece};
  std::array<Part_mesh, 2> wholes, pieces;
  for (std::size_t s = 0; s < 2; ++s) {
    wholes[s] = {shapes[s].surfaces[part[s]], meshes[s]->triangles};
    pieces[s] = piece_of(wholes[s], shapes[s].charts[part[s]], boxes[s]);
  }
  Pair_charts charts = pair_charts(pair, shapes[0], shapes[1], pieces[0].points, pieces[1].points);
  finely_charted(pieces[0], charts.source, longest_edge);
  finely_charted(pieces[1], charts.target, longest_edge);
  const double any_length = std::numeric_limits<double>::infinity();
  return {charts,
          {charted_mesh(wholes[0], charts.source, any_length), charted_mesh(wholes[1], charts.target, any_length)}};
}

} // namespace CGAL::Shape_correspondence::internal

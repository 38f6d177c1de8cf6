// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "map/Point_map.h"
#include "map/check_model.h"

#include <algorithm>
#include <limits>

namespace CGAL::Shape_correspondence::internal {
namespace {

// Half the width of the band in which one piece goes over to the next, as a fraction of the piece
constexpr double half_band = 0.15;

/// How much a piece counts at coordinates of its part's chart: 1 inside, 1/2 on its border with another piece.
double share_at(const Chart_box& box, const Point& k)
{
  double least = 1;
  for (int i = 0; i < 3; ++i) {
    const double band = half_band * (box.max()[i] - box.min()[i]);
    for (const auto& [is_border, inside] :
         {std::pair(box.min()[i] > -1, k[i] - box.min()[i]), std::pair(box.max()[i] < 1, box.max()[i] - k[i])})
      if (is_border) least = std::min(least, 0.5 + inside / (2 * band));
  }
  return std::max(least, 0.);
}

} // namespace

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

std::vector<Weighted_place> Point_map::operator()(std::size_t target_part, Eigen::Index triangle,
                                                  const Eigen::Vector3d& weights) const
{
  const auto& pieces = pieces_[target_part];
  const Eigen::Matrix3Xi& triangles = target_shape_.parts()[target_part].mesh.triangles;
  const Mesh_place place{triangle, weights};
  const Point p = place.of(target_.surfaces[target_part], triangles);
  std::vector<std::pair<const Piece*, double>> chosen;
  double rest = 1;
  if (pieces.size() > 1) {
    const Point k = target_.charts[target_part].coordinates(p);
    const Piece* nearest = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (const auto& piece : pieces) {
      if (const double share = std::min(share_at(piece->box, k), rest); share > 0) {
        chosen.emplace_back(piece.get(), share);
        rest -= share;
      }
      if (const double outside = piece->box.squaredExteriorDistance(k); outside < least)
        least = outside, nearest = piece.get();
    }
    if (chosen.empty()) chosen.emplace_back(nearest, 1.);
  } else if (!pieces.empty())
    chosen.emplace_back(pieces[0].get(), 1.);
  double sum = 0;
  for (const auto& [piece, share] : chosen)
    sum += share;
  std::vector<Weighted_place> result;
  for (const auto& [piece, share] : chosen) {
    const Mesh_place found =
        (*piece->finder)(piece->surfaces.charts.target.coordinates(p), place.of(piece->normals[1], triangles));
    result.push_back({piece->source, found.triangle, found.weights, share / sum});
  }
  std::stable_sort(result.begin(), result.end(),
                   [](const Weighted_place& a, const Weighted_place& b) { return a.share > b.share; });
  return result;
}

} // namespace CGAL::Shape_correspondence::internal

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_BLEND_BLEND_ACTOR_H
#define CGAL_SHAPE_CORRESPONDENCE_BLEND_BLEND_ACTOR_H

#include "blend/Fading_part.h"
#include "blend/Mirror_twins.h"
#include "blend/Part_morph.h"

#include <CGAL/Shape_correspondence/blend_shapes.h>

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

/// One shape of a blend.
struct Blend_side
{
  const Structural_graph& graph;
  const Segmented_shape& shape;
  int quarter_turns;
};

/// What one part, or a piece of one, goes through: one surface or two that follow each other.
struct Blend_actor
{
  std::string name;
  Blend_task task;
  std::optional<Part_morph> morph; ///< or else it fades
  std::optional<Fading_part> fading;
  double height = 0;                     ///< of its middle, at the ends' mean
  std::size_t twin = Mirror_twins::none; ///< its mirror image, where the blend is to be symmetric
  bool is_image = false;                 ///< made in the twin's coordinates, seen in the mirror
  bool stands = false;                   ///< on the ground, at both ends
  std::array<double, 2> foot = {0, 0};   ///< of one that stands, how high it is above the ground, by end

  int side() const { return task.source == Blend_task::no_part ? 1 : 0; } ///< of one that fades
  Points points(int surface, double t) const { return as_made(morph->points(surface, t)); }
  Points points_left(double left) const { return as_made(fading->points(left)); }
  Point place(const Point& p, double left) const
  {
    return is_image ? mirrored(fading->place(mirrored(p), left)) : fading->place(p, left);
  }

private:
  Points as_made(Points points) const { return is_image ? mirrored(std::move(points)) : std::move(points); }
};

/// The actors that a part of a side is, or pieces of it are.
inline std::vector<std::size_t> actors_of(const std::vector<Blend_actor>& actors, int side, std::size_t part)
{
  std::vector<std::size_t> result;
  for (std::size_t a = 0; a < actors.size(); ++a)
    if ((side == 0 ? actors[a].task.source : actors[a].task.target) == part) result.push_back(a);
  return result;
}

} // namespace internal
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_BLEND_BLEND_ACTOR_H

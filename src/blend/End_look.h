// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/Blend_part.h"

#include <array>
#include <cstddef>
#include <map>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// By two parts, the share of the first one's surface that is inside the second one.
using Overlaps = std::map<std::array<std::size_t, 2>, double>;

/// A part's surface, to find what is inside of it.
struct Seen_surface
{
  std::size_t part;
  Points samples; ///< evenly over it
  const contacts::Triangle_tree* tree;
  bool is_closed;
  bool looks_outwards; ///< its triangles
};

/// The overlaps of closed parts, those that are 0 left out.
Overlaps overlaps_of(const std::vector<Seen_surface>& surfaces);

/// The volume of the convex hull of surfaces, nearly; 0 of what is flat.
double hull_volume(const std::vector<const Points*>& surfaces);

/// What shapes in between are compared with at an end.
struct End_look
{
  End_look(const std::vector<Blend_part>& parts, int end);

  double area = 0, volume = 0; ///< of all parts; the volume of closed ones
  double hull = 0;             ///< volume of the convex hull
  double supports = 0;         ///< number of parts that stand on the ground
  Overlaps overlaps;
};

} // namespace CGAL::Shape_correspondence::internal

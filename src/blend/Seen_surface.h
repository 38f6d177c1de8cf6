// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/Blend_part.h"

#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

using Tree_pointers = std::vector<const contacts::Triangle_tree*>;

Tree_pointers pointers_to(const std::vector<contacts::Triangle_tree>& trees);

/// The widest gap that it takes to join all surfaces: the longest edge of a minimum spanning tree of their distances,
/// by Kruskal's algorithm. Distances are computed in the order of those of the boxes, which bound them from below,
/// until all are joined: seldom more than there are surfaces.
/// \param enough gaps that are no wider count as this wide, which saves the distances of what lies flat on each other
double widest_gap(const Tree_pointers& surfaces, double enough = 0);

/// The surface of a part in a shape, at an end of a blend or in between.
struct Seen_surface
{
  /// \param number of the part
  /// \param surface the one of its surfaces that there is
  Seen_surface(const std::vector<Blend_part>& parts, std::size_t number, int surface, const Points& points);

  std::size_t number;
  const Blend_part& part;
  const Rest_surface& rest;
  Points points;
  contacts::Triangle_tree tree;
};

/// The share of a surface that is inside another one, by samples.
double share_inside(const Seen_surface& a, const Seen_surface& b);

/// The number of parts that stand on the ground.
double number_of_supports(const std::vector<Seen_surface>& surfaces);

} // namespace CGAL::Shape_correspondence::internal

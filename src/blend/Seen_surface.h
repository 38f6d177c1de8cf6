// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/Blend_part.h"

#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

using Tree_pointers = std::vector<const contacts::Triangle_tree*>;

Tree_pointers pointers_to(const std::vector<contacts::Triangle_tree>& trees);

/// The widest gap that has to be bridged to join all surfaces: the longest edge of a minimum spanning tree of their
/// distances, by Kruskal's algorithm. Distances are computed in the order of the distances of bounding boxes, which are
/// lower bounds, until all surfaces are joined: seldom more distances than there are surfaces.
/// \param enough gaps that are no wider count as this wide, which saves computing the distances of surfaces in contact
double widest_gap(const Tree_pointers& surfaces, double enough = 0);

/// The surface of a part that is present in a shape, at an end of a blend or in between.
struct Seen_surface
{
  /// \param number index of the part
  /// \param surface index of its present surface
  Seen_surface(const std::vector<Blend_part>& parts, std::size_t number, int surface, const Points& points);

  std::size_t number;
  const Blend_part& part;
  int surface; ///< index of the surface of the part
  Points points;
  contacts::Triangle_tree tree;
};

/// The share of the area of `a` that is inside `b`, estimated by samples.
double share_inside(const Seen_surface& a, const Seen_surface& b);

double number_of_supports(const std::vector<Seen_surface>& surfaces);

} // namespace CGAL::Shape_correspondence::internal

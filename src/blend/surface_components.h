// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "map/Charted_mesh.h"

#include <vector>

namespace CGAL::Shape_correspondence::internal {

using Tree_pointers = std::vector<const contacts::Triangle_tree*>;

std::vector<contacts::Triangle_tree> trees_of(const std::vector<Part_mesh>& parts);
Tree_pointers pointers_to(const std::vector<contacts::Triangle_tree>& trees);

/// The widest gap that it takes to join all surfaces: the longest edge of a minimum spanning tree of their distances,
/// by Kruskal's algorithm. Distances are computed in the order of those of the boxes, which bound them from below,
/// until all are joined: seldom more than there are surfaces.
/// \param enough gaps that are no wider count as this wide, which saves the distances of what lies flat on each other
double widest_gap(const Tree_pointers& surfaces, double enough = 0);

} // namespace CGAL::Shape_correspondence::internal

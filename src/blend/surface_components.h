// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "base/Disjoint_sets.h"
#include "map/Charted_mesh.h"

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// The shortest line between two surfaces.
struct Surface_connection
{
  std::array<std::size_t, 2> surfaces;
  double length;
};

/// The shortest connections that join all components of surfaces, the shortest first: a minimum spanning forest, by
/// Kruskal's algorithm. Lengths are computed in the order of the distances of the boxes, which bound them from below,
/// until all are joined: seldom more than there are surfaces.
std::vector<Surface_connection> shortest_connections(const std::vector<const contacts::Triangle_tree*>& surfaces,
                                                     Disjoint_sets components);

/// The widest gap that it takes to join all surfaces.
double widest_gap(const std::vector<const contacts::Triangle_tree*>& surfaces);
double widest_gap(const std::vector<contacts::Triangle_tree>& surfaces);

std::vector<contacts::Triangle_tree> trees_of(const std::vector<Part_mesh>& parts);

} // namespace CGAL::Shape_correspondence::internal

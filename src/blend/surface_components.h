// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "base/Disjoint_sets.h"
#include "map/Charted_mesh.h"

#include <array>
#include <cstddef>
#include <optional>
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
double widest_gap(const std::vector<contacts::Triangle_tree>& surfaces);

std::vector<contacts::Triangle_tree> trees_of(const std::vector<Part_mesh>& parts);

/// Connected components of surfaces, two of which are connected if they are within a gap of each other. A component is
/// named by its first surface.
class Surface_components
{
public:
  using Tree = contacts::Triangle_tree;

  /// \param surfaces may move while they are used, which changes no component
  /// \param widest gap between surfaces that are connected
  Surface_components(std::vector<const Tree*> surfaces, double widest);

  std::size_t component_of(std::size_t surface) const { return components_[surface]; }

  /// Makes one component of those of two surfaces.
  void unite(std::size_t a, std::size_t b) { components_.unite(a, b); }

  /// The smallest component, by the diagonals of the boxes, if there are several.
  std::optional<std::size_t> smallest() const;

  /// The closest points of two surfaces.
  struct Connection
  {
    std::size_t from = 0, to = 0; ///< surfaces
    contacts::Closest_pair closest;
  };

  /// The shortest connection of a component with another, of which there is one; infinite where surfaces are nowhere.
  Connection shortest_connection(std::size_t component) const;

private:
  std::vector<const Tree*> surfaces_;
  Disjoint_sets components_;
};

} // namespace CGAL::Shape_correspondence::internal

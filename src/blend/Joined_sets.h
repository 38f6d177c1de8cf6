// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_BLEND_JOINED_SETS_H
#define CGAL_SHAPE_CORRESPONDENCE_BLEND_JOINED_SETS_H

#include "base/Disjoint_sets.h"
#include "base/quantized.h"
#include "shape/Triangle_tree.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

/// Surfaces in sets that hang together. A set is named by its first surface.
class Joined_sets
{
public:
  using Tree = contacts::Triangle_tree;

  /// \param widest gap between surfaces that hang together
  Joined_sets(std::vector<Tree> surfaces, double widest) : surfaces_(std::move(surfaces)), sets_(surfaces_.size())
  {
    for (std::size_t a = 0; a < surfaces_.size(); ++a)
      for (std::size_t b = a + 1; b < surfaces_.size(); ++b)
        if (sets_[a] != sets_[b] && surfaces_[a].is_within(surfaces_[b], widest * widest)) unite(a, b);
  }

  std::size_t set_of(std::size_t surface) const { return sets_[surface]; }

  /// To be called when a surface has been moved, which changes no set.
  void update(std::size_t surface, Tree tree) { surfaces_[surface] = std::move(tree); }

  /// Makes one set of those of two surfaces.
  void unite(std::size_t a, std::size_t b) { sets_.unite(a, b); }

  /// The smallest set, by the diagonals of the boxes, if there are several.
  std::optional<std::size_t> smallest() const
  {
    std::map<std::size_t, double> sizes;
    for (std::size_t a = 0; a < surfaces_.size(); ++a)
      sizes[sets_[a]] += surfaces_[a].box().diagonal().norm();
    if (sizes.size() < 2) return std::nullopt;
    const auto is_smaller = [](const auto& a, const auto& b) { return quantized(a.second) < quantized(b.second); };
    return std::min_element(sizes.begin(), sizes.end(), is_smaller)->first;
  }

  struct Way
  {
    std::size_t from = 0, to = 0; ///< surfaces
    contacts::Closest_pair closest;
  };

  /// The shortest way from a set to another, of which there is one; without end where surfaces are nowhere.
  Way way_from(std::size_t set) const
  {
    std::size_t other = 0;
    while (sets_[other] == set)
      ++other;
    Way shortest{set, other, {}};
    for (std::size_t a = 0; a < surfaces_.size(); ++a)
      for (std::size_t b = 0; b < surfaces_.size(); ++b) {
        if (sets_[a] != set || sets_[b] == set ||
            surfaces_[a].box().squaredExteriorDistance(surfaces_[b].box()) >= shortest.closest.squared)
          continue;
        const contacts::Closest_pair pair = surfaces_[a].nearly_closest(surfaces_[b]);
        if (pair.squared < shortest.closest.squared) shortest = {a, b, pair};
      }
    return shortest;
  }

private:
  std::vector<Tree> surfaces_;
  Disjoint_sets sets_;
};

} // namespace internal
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_BLEND_JOINED_SETS_H

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_MATCHING_ASSEMBLED_SHAPE_H
#define CGAL_SHAPE_CORRESPONDENCE_MATCHING_ASSEMBLED_SHAPE_H

#include "matching/Compared_shape.h"
#include "matching/Part_costs.h"
#include "matching/match_parts.h"

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

inline void drop_chains(Part_assemblies& assemblies)
{
  const auto has_link = [&](const std::vector<std::size_t>& panel) {
    return std::any_of(panel.begin(), panel.end(), [&](std::size_t part) { return bool(assemblies.is_link[part]); });
  };
  std::vector<std::vector<std::size_t>>& panels = assemblies.panels;
  panels.erase(std::remove_if(panels.begin(), panels.end(), has_link), panels.end());
  assemblies.is_link.assign(assemblies.is_link.size(), 0);
}

// A shape with all that is derived from it.
struct Assembled_shape
{
  const Aligned_shape& shape;
  Part_assemblies assemblies;
  Compared_shape compared;

  Assembled_shape(const Aligned_shape& shape, const Part_matching_options& options)
      : shape(shape), assemblies(part_assemblies(shape))
  {
    if (!options.panels) assemblies.panels.clear();
    if (!options.support) assemblies.support.clear();
    if (!options.chains) drop_chains(assemblies);
    compared = compared_shape(shape, assemblies);
  }

  std::size_t size() const { return shape.parts.size(); }
};

} // namespace internal
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_MATCHING_ASSEMBLED_SHAPE_H

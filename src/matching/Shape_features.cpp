// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "matching/Shape_features.h"

#include <tuple>

namespace CGAL::Shape_correspondence::internal {

Shape_features::Shape_features(const Aligned_shape& shape, const Part_matching_options& options)
    : shape(shape), options(options), assemblies(part_assemblies(shape, options))
{
  if (!options.panels) assemblies.panels.clear();
  if (!options.support) assemblies.support.clear();
  normalized = normalized_shape(shape, assemblies, options);
}

bool are_same(const Part_matching_options& a, const Part_matching_options& b)
{
  const auto values = [](const Part_matching_options& o) {
    const Part_cost_weights& w = o.weights;
    return std::make_tuple(w.overlap, w.extent, w.ground, w.place, w.orientation, w.chamfer, o.tolerance, o.warp_width,
                           o.main_surface, o.side_depth, o.wall_width, o.repetition, o.panels, o.support);
  };
  return values(a) == values(b);
}

} // namespace CGAL::Shape_correspondence::internal

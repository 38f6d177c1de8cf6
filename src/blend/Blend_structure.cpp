// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Blend_structure.h"

namespace CGAL::Shape_correspondence::internal {

Blend_structure::Blend_structure(const std::array<Blend_input, 2>& inputs, const Correspondence& correspondence,
                                 const Blend_options& options)
    : stage(inputs, options.size)
{
  parts = blend_parts(stage, correspondence, unlike);
  touches = internal::touches(stage, parts, options.contact_tolerance);
  roots = internal::roots(parts, touches);
  for (int end : {0, 1}) {
    std::vector<Seen_surface> seen;
    for (std::size_t i = 0; i < parts.size(); ++i)
      if (parts[i].is_at(end)) seen.emplace_back(parts, i, parts[i].end_surface(end), parts[i].end_points(end));
    looks[std::size_t(end)] = Shape_look(seen);
    if (!seen.empty() && !seen.back().part.is_matched()) warps[std::size_t(end)].emplace(stage, parts, unlike, end);
  }
}

} // namespace CGAL::Shape_correspondence::internal

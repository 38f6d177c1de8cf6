// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "map/Charted_shape.h"

#include "base/quarter_turn.h"

namespace CGAL::Shape_correspondence::internal {

Points to_common_frame(const Shape_frame& frame, int quarter_turns, const Points& world)
{
  return quarter_turn(quarter_turns) * frame.to_frame(world);
}

Charted_shape charted_shape(const Structural_graph& graph, int quarter_turns,
                            const std::vector<const Points*>& surfaces)
{
  const Shape_structure& shape = structure(graph);
  Charted_shape result;
  for (std::size_t i = 0; i < shape.parts.size(); ++i) {
    const Part_abstraction& part = shape.parts[i];
    const Points spine = to_common_frame(shape.frame, quarter_turns, part.control_points());
    const bool known = surfaces[i] && surfaces[i]->cols() > 0;
    result.surfaces.push_back(known ? to_common_frame(shape.frame, quarter_turns, *surfaces[i]) : spine);
    result.charts.push_back(Part_chart::around(part, spine, result.surfaces.back()));
    result.parts.push_back(&part);
  }
  return result;
}

} // namespace CGAL::Shape_correspondence::internal

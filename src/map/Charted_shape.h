// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "map/Part_chart.h"

#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// A shape in the common frame: height 1, standing on the ground.
struct Charted_shape
{
  std::vector<Points> surfaces; ///< vertices of the parts' meshes, or samples of their surfaces
  std::vector<Part_chart> charts;
  std::vector<Part_abstraction const*> parts;
};

Points to_common_frame(const Shape_frame& frame, int quarter_turns, const Points& world);

/// \param surfaces points of the parts' surfaces, in the world; if empty, the control points are used
Charted_shape charted_shape(const Structural_graph& graph, int quarter_turns,
                            const std::vector<const Points*>& surfaces);

} // namespace CGAL::Shape_correspondence::internal

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/Segmented_shape.h>
#include <CGAL/Shape_correspondence/Structural_graph.h>

namespace CGAL::Shape_correspondence::internal {

inline void check_model(const Structural_graph& graph, const Segmented_shape& shape)
{
  const auto& parts = structure(graph).parts;
  bool same = parts.size() == shape.parts().size();
  for (std::size_t i = 0; same && i < parts.size(); ++i)
    same = parts[i].name == shape.parts()[i].name;
  if (!same)
    throw Invalid_input(shape.name() + ": its parts are not those of the structural graph; take the graph that was " +
                        "built from this model");
}

} // namespace CGAL::Shape_correspondence::internal

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Shapes whose parts are boxes, with their graphs, and blends of them.
#pragma once

#include "box_shapes.h"

#include <CGAL/Shape_correspondence/blend_shapes.h>
#include <CGAL/Shape_correspondence/build_structural_graph.h>

#include <string>
#include <vector>

namespace box_models {

using namespace CGAL::Shape_correspondence;

struct Named_box
{
  std::string name;
  Point middle, size;
};

struct Box_model
{
  Segmented_shape shape;
  Structural_graph graph;
};

inline Box_model model_of(const Segmented_shape& shape)
{
  Structure_options options;
  options.abstraction.abstractor = Bounding_box_abstraction();
  Box_model result{shape, build_structural_graph(shape, options)};
  structure(result.graph).frame.mirror_x = structure(result.graph).frame.mirror_z = false;
  return result;
}

inline Box_model model_of(const std::vector<Named_box>& boxes, double scale = 1)
{
  Segmented_shape shape("boxes");
  for (const Named_box& box : boxes)
    shape.add_part(box.name, box_shapes::box(scale * box.middle, scale * box.size));
  return model_of(shape);
}

inline Correspondence same_parts(std::size_t count)
{
  Correspondence result;
  for (std::size_t i = 0; i < count; ++i)
    result.pairs.push_back({i, i});
  return result;
}

inline Shape_blend blend_of(const Box_model& source, const Box_model& target, const Correspondence& correspondence,
                            Blend_options options = {})
{
  options.samples = 3;
  return Shape_blend(source.graph, source.shape, target.graph, target.shape, correspondence, options);
}

inline const std::vector<Named_box>& stand()
{
  static const std::vector<Named_box> result = {{"base", {0, 0.05, 0}, {1, 0.1, 0.6}},
                                                {"column", {0, 0.5, 0}, {0.1, 0.8, 0.1}},
                                                {"top", {0, 0.95, 0}, {1, 0.1, 0.6}}};
  return result;
}

} // namespace box_models

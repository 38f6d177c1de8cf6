// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Models of `data/` with their graphs, and blends of them.
#pragma once

#include "blend_checks.h"

#include <CGAL/Shape_correspondence/IO/read_segmented_shape.h>
#include <CGAL/Shape_correspondence/blend_shapes.h>
#include <CGAL/Shape_correspondence/build_structural_graph.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <utility>

namespace blend_models {

using namespace CGAL::Shape_correspondence;
using namespace blend_checks;

struct Model
{
  Segmented_shape shape;
  Structural_graph graph;
};

inline const Model& model(const std::string& name)
{
  static std::map<std::string, Model> known;
  const auto found = known.find(name);
  if (found != known.end()) return found->second;
  Model result{IO::read_segmented_shape(SHAPE_CORRESPONDENCE_DATA_DIR "/" + name), {}};
  Structure_options options;
  options.abstraction.abstractor = Bounding_box_abstraction();
  result.graph = build_structural_graph(result.shape, options);
  return known.emplace(name, std::move(result)).first->second;
}

inline Shape_blend blend_of(const Model& source, const Model& target, const Correspondence& correspondence)
{
  Blend_options options;
  options.samples = 3; // one of the samples is half-way
  return Shape_blend(source.graph, source.shape, target.graph, target.shape, correspondence, options);
}

inline Shape_blend blend_of(const std::string& source, const std::string& target)
{
  return blend_of(model(source), model(target), find_correspondence(model(source).graph, model(target).graph));
}

inline Measured_blend measured_blend(const std::string& source, const std::string& target)
{
  return {model(source), model(target), find_correspondence(model(source).graph, model(target).graph)};
}

inline std::size_t part_named(const Model& model, const std::string& name)
{
  const auto& parts = structure(model.graph).parts;
  return std::size_t(std::find_if(parts.begin(), parts.end(), [&](const auto& p) { return p.name == name; }) -
                     parts.begin());
}

} // namespace blend_models

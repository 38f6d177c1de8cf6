// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Structural graphs whose parts are abstracted by their bounding boxes, and correspondences given by hand.
#ifndef SHAPE_CORRESPONDENCE_TEST_BOXED_GRAPHS_H
#define SHAPE_CORRESPONDENCE_TEST_BOXED_GRAPHS_H

#include <CGAL/Shape_correspondence/Correspondence.h>
#include <CGAL/Shape_correspondence/build_structural_graph.h>

#include <utility>
#include <vector>

namespace boxed_graphs {

using namespace CGAL::Shape_correspondence;

inline Structural_graph graph_of(const Segmented_shape& shape)
{
  Structure_options options;
  options.abstraction.abstractor = Bounding_box_abstraction();
  return build_structural_graph(shape, options);
}

inline Correspondence pairing(std::vector<Part_correspondence> pairs)
{
  Correspondence result;
  result.pairs = std::move(pairs);
  return result;
}

/// The identity correspondence.
inline Correspondence identity(const Segmented_shape& shape)
{
  Correspondence result;
  for (std::size_t i = 0; i < shape.parts().size(); ++i)
    result.pairs.push_back({i, i});
  return result;
}

} // namespace boxed_graphs

#endif // SHAPE_CORRESPONDENCE_TEST_BOXED_GRAPHS_H

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Finds parts of aligned graphs by their indices in the handwritten graphs.
#ifndef SHAPE_CORRESPONDENCE_TEST_ALIGNED_GRAPHS_H
#define SHAPE_CORRESPONDENCE_TEST_ALIGNED_GRAPHS_H

#include "hand_made_graphs.h"
#include "structure/align_shapes.h"

#include <algorithm>

namespace hand_made {

inline std::size_t index_of(const Aligned_shape& shape, std::size_t original)
{
  return std::size_t(std::find(shape.original.begin(), shape.original.end(), original) - shape.original.begin());
}

} // namespace hand_made

#endif // SHAPE_CORRESPONDENCE_TEST_ALIGNED_GRAPHS_H

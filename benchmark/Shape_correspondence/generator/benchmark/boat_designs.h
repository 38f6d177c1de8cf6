// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_GENERATOR_BENCHMARK_BOAT_DESIGNS_H
#define CGAL_SHAPE_CORRESPONDENCE_GENERATOR_BENCHMARK_BOAT_DESIGNS_H

#include "../assembly.h"
#include "../primitives.h"

namespace CGAL {
namespace Shape_correspondence {
namespace generator {

/// A rowing boat with a pair of oars, a dinghy with one mast, and a yawl with two; bows point to +z.
std::vector<Assembly> boats();

} // namespace generator
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_GENERATOR_BENCHMARK_BOAT_DESIGNS_H

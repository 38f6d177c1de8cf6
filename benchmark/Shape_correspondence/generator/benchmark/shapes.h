// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_GENERATOR_BENCHMARK_SHAPES_H
#define CGAL_SHAPE_CORRESPONDENCE_GENERATOR_BENCHMARK_SHAPES_H

#include "../assembly.h"

namespace CGAL {
namespace Shape_correspondence {
namespace generator {

/// The shapes that methods are compared on: fifteen of each category, no two of one design. Their measures are drawn
/// from fixed seeds.
std::vector<Assembly> benchmark_shapes();

/// The shapes that roles are learned from: those of the benchmark, further beds, lamps, tables and velocipedes, and
/// cars, plants, shelves and sofas. No method is compared on the further ones.
std::vector<Assembly> training_shapes();

/// Boats and carts, three of each: further kinds of the paper's gallery, which no method is set or compared on.
std::vector<Assembly> gallery_shapes();

} // namespace generator
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_GENERATOR_BENCHMARK_SHAPES_H

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_GENERATOR_BENCHMARK_FIXTURE_DESIGNS_H
#define CGAL_SHAPE_CORRESPONDENCE_GENERATOR_BENCHMARK_FIXTURE_DESIGNS_H

#include "../assembly.h"

#include <cstdint>

namespace CGAL {
namespace Shape_correspondence {
namespace generator {

/// Lamps of further kinds: lanterns that hang, stand on a post or are on a wall, candle chandeliers, spots, uplights,
/// sconces; `seed` is of the first one.
std::vector<Assembly> fixtures(std::uint64_t seed);

} // namespace generator
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_GENERATOR_BENCHMARK_FIXTURE_DESIGNS_H

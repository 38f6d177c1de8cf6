// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_GENERATOR_BENCHMARK_DESK_DESIGNS_H
#define CGAL_SHAPE_CORRESPONDENCE_GENERATOR_BENCHMARK_DESK_DESIGNS_H

#include "../assembly.h"

#include <cstdint>

namespace CGAL {
namespace Shape_correspondence {
namespace generator {

/// Tables on side panels, on frames, on columns with feet, and on cabinets, which `table_designs()` has not; `seed` is
/// of the first one.
std::vector<Assembly> desks(std::uint64_t seed);

} // namespace generator
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_GENERATOR_BENCHMARK_DESK_DESIGNS_H

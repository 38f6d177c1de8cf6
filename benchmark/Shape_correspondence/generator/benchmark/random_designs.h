// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_GENERATOR_BENCHMARK_RANDOM_DESIGNS_H
#define CGAL_SHAPE_CORRESPONDENCE_GENERATOR_BENCHMARK_RANDOM_DESIGNS_H

#include "../assembly.h"

#include <cstdint>

namespace CGAL {
namespace Shape_correspondence {
namespace generator {

/// Fifteen shapes of each category whose styles are drawn, too: a check for what was chosen on `benchmark_shapes()`.
/// Chairs, tables, beds and aeroplanes combine options as no shape of the benchmark does; lamps and velocipedes have
/// other numbers and sizes.
std::vector<Assembly> random_shapes(std::uint64_t seed);

} // namespace generator
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_GENERATOR_BENCHMARK_RANDOM_DESIGNS_H

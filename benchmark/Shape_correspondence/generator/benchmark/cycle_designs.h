// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_GENERATOR_BENCHMARK_CYCLE_DESIGNS_H
#define CGAL_SHAPE_CORRESPONDENCE_GENERATOR_BENCHMARK_CYCLE_DESIGNS_H

#include "../assembly.h"

#include <cstdint>

namespace CGAL {
namespace Shape_correspondence {
namespace generator {

/// Velocipedes of fewer parts than those of `velocipedes()`, as models from catalogues often are: a wheel is one part,
/// and so may be a frame, a fork or both stays; `seed` is of the first one.
std::vector<Assembly> cycles(std::uint64_t seed);

} // namespace generator
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_GENERATOR_BENCHMARK_CYCLE_DESIGNS_H

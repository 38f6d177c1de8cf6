// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_GENERATOR_BENCHMARK_BED_KINDS_H
#define CGAL_SHAPE_CORRESPONDENCE_GENERATOR_BENCHMARK_BED_KINDS_H

#include "../assembly.h"

#include <cstdint>

namespace CGAL {
namespace Shape_correspondence {
namespace generator {

/// Beds of further kinds: day beds, hospital beds, beds above a desk or others, beds with drawers, metal beds; `seed`
/// is of the first one.
std::vector<Assembly> bed_kinds(std::uint64_t seed);

} // namespace generator
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_GENERATOR_BENCHMARK_BED_KINDS_H

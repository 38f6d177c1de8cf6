// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_GENERATOR_BENCHMARK_MADE_BED_DESIGNS_H
#define CGAL_SHAPE_CORRESPONDENCE_GENERATOR_BENCHMARK_MADE_BED_DESIGNS_H

#include "bed_designs.h"

#include <cstdint>
#include <string>

namespace CGAL {
namespace Shape_correspondence {
namespace generator {

/// Nothing, a blanket, one that is folded back at the head, or a band across the foot.
enum class Bedding { none, blanket, fold, band };

/// \param top of the mattress
void add_bedding(Assembly& bed, const Bed_frame& f, Bedding bedding, double top, Random& random,
                 const std::string& suffix = "");

/// Beds as in `bed_designs()`, but with bedding, and on frames in one piece or on boxes; `seed` is of the first one.
std::vector<Assembly> made_beds(std::uint64_t seed);

} // namespace generator
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_GENERATOR_BENCHMARK_MADE_BED_DESIGNS_H

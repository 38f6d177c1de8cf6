// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_GENERATOR_BENCHMARK_SOFA_KINDS_H
#define CGAL_SHAPE_CORRESPONDENCE_GENERATOR_BENCHMARK_SOFA_KINDS_H

#include "../assembly.h"

#include <cstdint>

namespace CGAL {
namespace Shape_correspondence {
namespace generator {

/// Sofas and armchairs of further kinds: around a corner, in a frame of tubes or of wood, with backs in two parts, of
/// loose cushions on a body; `seed` is of the first one.
std::vector<Assembly> sofa_kinds(std::uint64_t seed);

} // namespace generator
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_GENERATOR_BENCHMARK_SOFA_KINDS_H

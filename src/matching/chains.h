// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_MATCHING_CHAINS_H
#define CGAL_SHAPE_CORRESPONDENCE_MATCHING_CHAINS_H

#include "matching/Shape_layout.h"

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

// The chains of a shape: at least `minimum_repetition` rings (closed curves) of like size, each of which touches the
// next one; the parts of each, ascending.
std::vector<std::vector<std::size_t>> chains_of(const Aligned_shape& shape, const Shape_layout& layout);

} // namespace internal
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_MATCHING_CHAINS_H

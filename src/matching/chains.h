// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "matching/Shape_layout.h"

#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

// The chains of a shape: at least `minimum_repetition` rings (closed curves) of like size, each of which touches the
// next one; the parts of each, ascending.
std::vector<std::vector<std::size_t>> chains_of(const Aligned_shape& shape, const Shape_layout& layout);

} // namespace CGAL::Shape_correspondence::internal

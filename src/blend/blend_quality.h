// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/In_between_shape.h"

#include <cstddef>

namespace CGAL::Shape_correspondence::internal {

/// The measures of a shape, and which tolerances it exceeds.
Blend_check check(const In_between_shape& shape);

/// How many measures of a shape, or of several, are over their tolerances.
std::size_t number_of_faults(const Blend_quality& quality, const Blend_structure& blend);

} // namespace CGAL::Shape_correspondence::internal

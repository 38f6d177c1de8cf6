// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/In_between_shape.h"

#include <CGAL/Shape_correspondence/blend_shapes.h>

namespace CGAL::Shape_correspondence::internal {

Blend_quality quality(In_between_shape shape);

/// `Blend_quality::asymmetry` of that end which is less symmetric; shapes in between are measured against it.
double end_asymmetry(const Blend_structure& blend);

/// The quality, and what does not hold within the tolerances of `Shape_blend`.
Blend_check check(In_between_shape shape);

} // namespace CGAL::Shape_correspondence::internal

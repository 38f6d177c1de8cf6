// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_BLEND_BLEND_QUALITY_H
#define CGAL_SHAPE_CORRESPONDENCE_BLEND_BLEND_QUALITY_H

#include "blend/In_between_shape.h"

#include <CGAL/Shape_correspondence/blend_shapes.h>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

Blend_quality quality(const In_between_shape& shape);

/// `Blend_quality::asymmetry` of that end which is less symmetric; shapes in between are measured against it.
double end_asymmetry(const Blend_structure& blend);

/// The quality, and what does not hold within the tolerances of `Shape_blend`.
Blend_check check(const In_between_shape& shape);

} // namespace internal
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_BLEND_BLEND_QUALITY_H

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Segmented_shape.h>
#include <CGAL/Shape_correspondence/Shape_frame.h>

#include <array>

namespace CGAL::Shape_correspondence::internal {

/// The frame of a shape, the same to the bit whatever the order of the parts.
Shape_frame frame_of(const Segmented_shape& shape);

/// The frames of a shape if x, y or z is up.
std::array<Shape_frame, 3> frames_by_axis(const Segmented_shape& shape);

} // namespace CGAL::Shape_correspondence::internal

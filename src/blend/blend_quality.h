// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/In_between_shape.h"

namespace CGAL::Shape_correspondence::internal {

/// The measures of a shape, and which tolerances it exceeds.
Blend_check check(const In_between_shape& shape);

} // namespace CGAL::Shape_correspondence::internal

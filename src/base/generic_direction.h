// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Points.h>

namespace CGAL::Shape_correspondence::internal {

/// A direction near y, oblique to all axes, so that positions of different points along it are hardly ever equal.
inline Point generic_direction() { return Point(0.6, 1, 0.36).normalized(); }

} // namespace CGAL::Shape_correspondence::internal

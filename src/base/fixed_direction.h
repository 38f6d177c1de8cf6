// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Points.h>

#include <cmath>
#include <initializer_list>

namespace CGAL::Shape_correspondence::internal {

/// A unit vector across a unit direction: towards y as far as it can, or towards x if the direction is near to y.
/// Unlike Eigen's `unitOrthogonal()` it does not depend on the last digits of a direction along a coordinate axis.
inline Point some_normal(const Point& direction)
{
  const double near = 0.8; // cosine
  const Point towards = std::abs(direction.y()) < near ? Point::UnitY() : Point::UnitX();
  return (towards - direction.dot(towards) * direction).normalized();
}

/// A unit vector or its opposite: the one whose y is positive, or x or z, the first of them that is not small.
inline Point with_fixed_sign(const Point& direction)
{
  const double small = 0.1;
  for (const int axis : {1, 0, 2}) {
    if (std::abs(direction[axis]) > small) {
      return direction[axis] > 0 ? direction : Point(-direction);
    }
  }
  return direction;
}

} // namespace CGAL::Shape_correspondence::internal

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <algorithm>

namespace CGAL::Shape_correspondence::internal {

// Numbers that a motion of the shape changes by rounding alone are compared after rounding to this grid, so that ties
// stay ties and are settled by index.
constexpr double comparison_grid = 1e-6;

// What is beyond the grid, infinite too, is the last step. \pre a number
inline long quantized(double value)
{
  constexpr double last = 9e18;
  const double steps = std::min(last, std::max(-last, value / comparison_grid));
  // std::lround() is a call
  return long(steps < 0 ? steps - 0.5 : steps + 0.5);
}

// Squared length, in units of the shape's height, under which a vector has no direction
constexpr double zero_squared_length = 1e-18;

} // namespace CGAL::Shape_correspondence::internal

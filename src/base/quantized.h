// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <algorithm>
#include <cstdint>

namespace CGAL::Shape_correspondence::internal {

/// Numbers that a motion of the shape changes by rounding alone are compared after rounding to this grid, so that ties
/// stay ties and are settled by index.
constexpr double comparison_grid = 1e-6;

/// A number of steps of the grid. Of 64 bits everywhere: `long` has 32 on some machines.
using Steps = std::int64_t;

/// The nearest step of the grid; the first or last one for what is beyond it, infinite too; the first one for NaN.
inline Steps quantized(double value)
{
  constexpr double last = 9e18; // below 2^63
  const double steps = std::min(last, std::max(-last, value / comparison_grid));
  // std::lround() is a function call
  return Steps(steps < 0 ? steps - 0.5 : steps + 0.5);
}

/// Squared length, in units of the shape's height, under which a vector has no direction
constexpr double zero_squared_length = 1e-18;

} // namespace CGAL::Shape_correspondence::internal

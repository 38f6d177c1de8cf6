// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <algorithm>
#include <cstdint>

namespace CGAL::Shape_correspondence::internal {

/// Grid to which numbers are rounded before they are compared, so that values which differ by rounding after a motion
/// of the shape stay ties, settled by index.
constexpr double comparison_grid = 1e-6;

/// A number of steps of the grid, with 64 bits on all machines, unlike `long`.
using Steps = std::int64_t;

/// The nearest step of the grid, saturated at both ends; the lowest step for NaN.
inline Steps quantized(double value)
{
  constexpr double last = 9e18; // a number below 2^63
  const double steps = std::min(last, std::max(-last, value / comparison_grid));
  // faster than std::lround(), which is a function call
  return Steps(steps < 0 ? steps - 0.5 : steps + 0.5);
}

/// Squared length, over the squared height of the shape, below which a vector has no direction.
constexpr double zero_squared_length = 1e-18;

} // namespace CGAL::Shape_correspondence::internal

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <algorithm>

namespace CGAL::Shape_correspondence::internal {

// Unlike `std::clamp()`, these functions return 0 for NaN, so that it never becomes an index.

/// A number clamped to [0, 1]; 0 for NaN.
inline double clamped_to_unit(double x) { return x > 0 ? std::min(x, 1.) : 0; }

/// Index, from 0 to `last`, of the cell of width 1 that contains x; 0 for NaN. Clamps before the conversion to `int`,
/// which is undefined for large numbers.
inline int clamped_cell(double x, int last) { return x > 0 ? int(std::min(x, double(last))) : 0; }

} // namespace CGAL::Shape_correspondence::internal

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <algorithm>

namespace CGAL::Shape_correspondence::internal {

// Unlike `std::clamp()` these have a result for NaN, too, so that it becomes no index.

/// A number clamped to [0, 1]; 0 for NaN.
inline double clamped_to_unit(double x) { return x > 0 ? std::min(x, 1.) : 0; }

/// The cell of a position among cells of width 1, from 0 to `last`; 0 for NaN. Clamped before it becomes an `int`,
/// since a larger number cannot.
inline int clamped_cell(double x, int last) { return x > 0 ? int(std::min(x, double(last))) : 0; }

} // namespace CGAL::Shape_correspondence::internal

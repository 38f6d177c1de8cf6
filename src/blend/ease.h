// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <algorithm>
#include <cmath>

namespace CGAL::Shape_correspondence::internal {

/// How much of a motion is done after a share of its time: it starts and stops gently.
inline double eased(double t)
{
  const double share = std::clamp(t, 0., 1.);
  return share * share * (3 - 2 * share);
}

/// The share of the time after which a share of a motion is done: the inverse.
inline double time_of(double done) { return 0.5 - std::sin(std::asin(1 - 2 * std::clamp(done, 0., 1.)) / 3); }

} // namespace CGAL::Shape_correspondence::internal

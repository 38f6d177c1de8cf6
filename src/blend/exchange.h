// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/ease.h"

namespace CGAL::Shape_correspondence::internal {

/// How far a part is on its way when what takes its place is there as a whole, and it begins to thin. Thinning and
/// thickening take little of the way, before half of it: half-way, and most of the time, there is one of the two only.
constexpr double exchange_time = 0.42, exchange_overlap = 0.08;

/// In an exchange, how much there is of what an end has.
inline double exchange_remaining(int end, double progress)
{
  const double past = end == 0 ? progress - exchange_time : exchange_time - progress;
  return 1 - eased(past / exchange_overlap);
}

} // namespace CGAL::Shape_correspondence::internal

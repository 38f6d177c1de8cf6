// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/ease.h"

#include <array>

namespace CGAL::Shape_correspondence::internal {

/// When, on the way of an exchange, what the target has comes, and what the source has goes.
struct Exchange_times
{
  std::array<double, 2> come, go;

  /// How much there is of what an end has.
  double remaining(int end, double progress) const
  {
    const auto done = [&](const std::array<double, 2>& times) {
      return eased((progress - times[0]) / (times[1] - times[0]));
    };
    return end == 0 ? 1 - done(go) : done(come);
  }
};

/// Of two surfaces in one place: quickly, before half of the way, so that most of the time there is one of them only.
constexpr Exchange_times in_place = {{0.34, 0.42}, {0.42, 0.5}};
/// Of sets of parts: the one is there as a whole, and carries, before half of the other has gone.
constexpr Exchange_times of_sets = {{0.16, 0.5}, {0.33, 0.69}};

} // namespace CGAL::Shape_correspondence::internal

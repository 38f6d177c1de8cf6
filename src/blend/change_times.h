// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <algorithm>
#include <array>

namespace CGAL::Shape_correspondence::internal {

/// When, on the way of parts that come in the place of others, the new ones come and the old ones go.
struct Change_times
{
  std::array<double, 2> come, go;

  /// How much there is of what an end has.
  double remaining(int end, double progress) const
  {
    const auto done = [&](const std::array<double, 2>& times) {
      return std::clamp((progress - times[0]) / (times[1] - times[0]), 0., 1.);
    };
    return end == 0 ? 1 - done(go) : done(come);
  }
};

/// First those come that the shape needs to stand, or to hang together; the others wait until there is room for them.
constexpr Change_times of_needed = {{0.15, 0.45}, {0.45, 0.75}}, of_others = {{0.4, 0.75}, {0.15, 0.5}};

} // namespace CGAL::Shape_correspondence::internal

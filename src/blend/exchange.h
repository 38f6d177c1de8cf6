// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <algorithm>
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
      return std::clamp((progress - times[0]) / (times[1] - times[0]), 0., 1.);
    };
    return end == 0 ? 1 - done(go) : done(come);
  }
};

/// Of two surfaces in one place: quickly, before half of the way, so that most of the time there is one of them only.
constexpr Exchange_times in_place = {{0.34, 0.42}, {0.42, 0.5}};
/// Of parts that come and go, one set after the other: first those come that the shape needs to stand, or to hang
/// together; the others wait until there is room for them.
constexpr Exchange_times of_needed = {{0.15, 0.45}, {0.45, 0.75}}, of_others = {{0.4, 0.75}, {0.15, 0.5}};

} // namespace CGAL::Shape_correspondence::internal

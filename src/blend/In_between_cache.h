// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/In_between_shape.h"

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>

namespace CGAL::Shape_correspondence::internal {

/// The shapes of a blend by one schedule, those that were asked for first kept as long as they are small: a frame is
/// written and checked, and perhaps shown, all at the same time. Threads may share it.
class In_between_cache
{
public:
  In_between_cache(std::shared_ptr<const Blend_structure> blend, Task_times times);

  /// The shape at `t`, strictly between the ends.
  std::shared_ptr<const In_between_shape> at(double t);

private:
  static constexpr std::size_t most_points = 4'000'000; ///< of all shapes that are kept: 100 MB

  std::shared_ptr<const Blend_structure> blend_;
  Task_times times_;
  std::mutex mutex_; ///< of what follows
  std::map<double, std::shared_ptr<const In_between_shape>> shapes_;
  std::size_t points_ = 0;
};

} // namespace CGAL::Shape_correspondence::internal

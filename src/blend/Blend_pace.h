// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/In_between_shape.h"

#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// When a blend shows which moment of its schedule, so that shapes change evenly over time.
class Blend_pace
{
public:
  /// \param times of the tasks, moments in [0, 1]
  Blend_pace(const Blend_structure& blend, const Task_times& times);

  /// The shape at `t` in [0, 1].
  In_between_shape shape(const Blend_structure& blend, double t) const { return {blend, times_, moment(t)}; }
  /// The time of the blend at a moment of the schedule.
  double time(double moment) const;
  /// The time of the blend at which a task has made progress.
  double time_of(std::size_t task, double progress) const;

private:
  double moment(double t) const;

  Task_times times_;
  std::vector<double> done_; ///< how much of all change is done, at even moments
};

} // namespace CGAL::Shape_correspondence::internal

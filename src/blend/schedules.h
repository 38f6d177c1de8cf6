// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/In_between_shape.h"

#include <CGAL/Shape_correspondence/blend_shapes.h>

#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// In which order old parts are exchanged for new ones; numbers in `schedule_names()`.
enum class Blend_order { FROM_THE_GROUND, FROM_THE_TOP, AT_ONE_TIME };

/// The names of all schedules.
const std::vector<std::string>& schedule_names();

/// The tasks with their times: those of one group at one time.
std::vector<Blend_task> tasks_in_order(const Blend_structure& blend, Blend_order order);
bool have_same_times(const std::vector<Blend_task>& a, const std::vector<Blend_task>& b);

/// All schedules, judged by samples of their in-between shapes, the best one first.
std::vector<Blend_schedule> ranked_schedules(const Blend_structure& blend, const Blend_options& options);

} // namespace CGAL::Shape_correspondence::internal

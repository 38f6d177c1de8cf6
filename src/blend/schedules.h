// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/In_between_shape.h"

#include <CGAL/Shape_correspondence/blend_shapes.h>

#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// The times of tasks in which parts that are not matched come and go, those of one group at one time.
/// \param groups by part
Task_times times_in_turn(const std::vector<Blend_part>& parts, const std::vector<std::size_t>& groups,
                         bool from_the_ground);

/// The schedules of all layouts, judged by samples of their in-between shapes, the best one first.
std::vector<Blend_schedule> ranked_schedules(const Blend_structure& blend, const Blend_options& options);

} // namespace CGAL::Shape_correspondence::internal

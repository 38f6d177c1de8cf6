// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/In_between_shape.h"

#include <CGAL/Shape_correspondence/blend_shapes.h>

#include <vector>

namespace CGAL::Shape_correspondence::internal {

Task_times times_of(const Blend_schedule& schedule);

/// The schedules that there are, in which all of the time is used.
std::vector<Blend_schedule> plausible_schedules(const std::vector<Blend_part>& parts);

/// Judges schedules by samples of their in-between shapes, and sorts them, the best one first.
void rank(std::vector<Blend_schedule>& schedules, const Blend_structure& blend, const Blend_options& options);

} // namespace CGAL::Shape_correspondence::internal

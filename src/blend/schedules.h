// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/In_between_shape.h"

#include <CGAL/Shape_correspondence/blend_shapes.h>

#include <vector>

namespace CGAL::Shape_correspondence::internal {

bool have_same_times(const std::vector<Blend_task>& a, const std::vector<Blend_task>& b);

/// All schedules with their qualities by samples of their in-between shapes, the best one first.
std::vector<Blend_schedule> ranked_schedules(const Blend_structure& blend, const Blend_options& options);

} // namespace CGAL::Shape_correspondence::internal

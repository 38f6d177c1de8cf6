// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "cli/load_shape.h"

#include <CGAL/Shape_correspondence/blend_shapes.h>

#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::cli {

/// Removes pairs that are less probable than `least`. \return a warning for each of them
std::vector<std::string> remove_unlikely(Correspondence& correspondence, double least, const Loaded_shape& source,
                                         const Loaded_shape& target);

/// The size of the frames where none is asked for: `SAME`, with a warning, for shapes that seem to be in other units.
Blend_size likely_size(const Loaded_shape& source, const Loaded_shape& target, std::vector<std::string>& warnings);

/// Tells which parts have no map onto their counterparts, and why.
void warn_of_obstacles(const Shape_blend& blend, const Loaded_shape& source, const Loaded_shape& target,
                       std::vector<std::string>& warnings);

} // namespace CGAL::Shape_correspondence::cli

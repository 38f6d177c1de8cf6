// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "cli/load_shape.h"

#include <CGAL/Shape_correspondence/blend_shapes.h>

#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::cli {

/// The size of the frames where none is asked for: `SAME`, with a warning, for shapes that seem to be in other units.
Blend_size likely_size(const Loaded_shape& source, const Loaded_shape& target, std::vector<std::string>& warnings);

/// Tells which parts exchange their surfaces, and why.
void warn_of_exchanges(const Shape_blend& blend, const Loaded_shape& source, const Loaded_shape& target,
                       std::vector<std::string>& warnings);

} // namespace CGAL::Shape_correspondence::cli

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "writer.h"

#include <string>

namespace CGAL::Shape_correspondence::generator {

/// A picture on which seams, flips and stretching show: 8 by 8 squares, redder to the right, greener downwards, every
/// other one bluer, each with a dark upper left corner.
std::string test_picture();

/// The OBJ file of the shape, its material and its texture.
Files textured_file(const Assembly& shape);

} // namespace CGAL::Shape_correspondence::generator

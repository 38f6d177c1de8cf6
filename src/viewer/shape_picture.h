// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "io/colours.h"

#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::IO {

/// A picture of a shape from the front, the right and above, a colour a part.
/// \param width of the square picture in pixels
/// \return a BMP file
std::string shape_picture(const Segmented_shape& shape, const std::vector<Colour>& colours, int width);

} // namespace CGAL::Shape_correspondence::IO

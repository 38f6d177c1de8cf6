// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_GENERATOR_TEXTURES_H
#define CGAL_SHAPE_CORRESPONDENCE_GENERATOR_TEXTURES_H

#include "writer.h"

#include <string>

namespace CGAL {
namespace Shape_correspondence {
namespace generator {

/// A picture on which seams, flips and stretching show: 8 by 8 squares, redder to the right, greener downwards, every
/// other one bluer, each with a dark upper left corner.
std::string test_picture();

/// The OBJ file of the shape, its material and its texture.
Files textured_file(const Assembly& shape);

} // namespace generator
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_GENERATOR_TEXTURES_H

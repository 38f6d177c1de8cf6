// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read/model_stream.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

// Replaces import_parts.cpp in browsers and on Windows

namespace CGAL::Shape_correspondence::IO {

Model_content import_parts(const std::string& file, const Reading_options&)
{
  throw Invalid_input(
      file + ": files of this format are read by another program (shape_correspondence_import), which "
             "neither browsers nor Windows run; save the model as GLB without compression, OBJ, PLY, STL or OFF");
}

} // namespace CGAL::Shape_correspondence::IO

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_IO_INPUT_FILE_H
#define CGAL_SHAPE_CORRESPONDENCE_IO_INPUT_FILE_H

#include <fstream>
#include <string>

namespace CGAL {
namespace Shape_correspondence {
namespace IO {

/// A file, opened for reading. \throw Invalid_input if it is not there or cannot be opened; names it
std::ifstream open_input(const std::string& path);

/// The extension of a file's name with its dot, in small letters; empty: none.
std::string lower_extension(const std::string& path);

} // namespace IO
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_IO_INPUT_FILE_H

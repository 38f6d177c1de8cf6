// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_IO_CHECKED_FILE_H
#define CGAL_SHAPE_CORRESPONDENCE_IO_CHECKED_FILE_H

#include <optional>
#include <string>

namespace CGAL {
namespace Shape_correspondence {
namespace IO {

/// A file that is kept for later: its first line is a title, which says what it is, and a digest of the rest. Many
/// processes may use one at a time.

/// Writes such a file, all of it or nothing. \throw Invalid_input if that fails
void write_checked_file(const std::string& path, const std::string& title, const std::string& content);

/// The content of such a file; none if there is no such file, or it is damaged or has another title.
std::optional<std::string> read_checked_file(const std::string& path, const std::string& title);

} // namespace IO
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_IO_CHECKED_FILE_H

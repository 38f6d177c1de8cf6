// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <optional>
#include <string>

namespace CGAL::Shape_correspondence::IO {

/// A digest (SHA-1) of bytes.
std::string digest(const std::string& bytes);

/// All bytes of a file; none if it cannot be read, or is a pipe or a device.
std::string bytes_of_file(const std::string& path);

/// A file that is kept for later: its first line is a title, which says what it is, and a digest of the rest. Many
/// processes may use one at a time.

/// Writes such a file, all of it or nothing. \throw Invalid_input if that fails
void write_checked_file(const std::string& path, const std::string& title, const std::string& content);

/// The same for an entry of a cache or store, see `write_entry()`.
void write_checked_entry(const std::string& path, const std::string& title, const std::string& content);

/// The content of such a file, given all of its text; none if it is damaged or has another title.
std::optional<std::string> checked_content(const std::string& file, const std::string& title);

/// The content of such a file; none if there is no such file, or it is damaged or has another title.
std::optional<std::string> read_checked_file(const std::string& path, const std::string& title);

} // namespace CGAL::Shape_correspondence::IO

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <optional>
#include <string>

namespace CGAL::Shape_correspondence::IO {

/// A digest (SHA-1) of bytes.
std::string digest(const std::string& bytes);

/// The content of a file; empty if it cannot be read, or is a pipe or a device.
std::string bytes_of_file(const std::string& path);

/// A *checked file* starts with a line with a title, for its kind, and a digest. Several processes may use one.

/// Writes a checked file atomically. \throw Invalid_input on failure
void write_checked_file(const std::string& path, const std::string& title, const std::string& content);

/// Writes a checked file as an entry of a cache or store, see `write_entry()`.
void write_checked_entry(const std::string& path, const std::string& title, const std::string& content);

/// The content of a checked file, given its entire text; none if it is damaged or has another title.
std::optional<std::string> checked_content(const std::string& file, const std::string& title);

/// The content of a checked file; none if it does not exist, is damaged or has another title.
std::optional<std::string> read_checked_file(const std::string& path, const std::string& title);

} // namespace CGAL::Shape_correspondence::IO

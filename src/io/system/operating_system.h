// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

namespace CGAL::Shape_correspondence::IO {

// Functions of the operating system beyond the standard library, in posix.cpp and windows.cpp. Paths are UTF-8.

/// Sets up streams, signals and memory. \return the arguments of `main()` in UTF-8, without the program's name
std::vector<std::string> start_program(int argc, char* argv[]);

/// The file of this program; empty if unknown.
std::filesystem::path program_file();

/// Whether standard error is a terminal that can erase lines.
bool errors_are_on_terminal();

/// Peak memory of the process, in units of 2^20 bytes.
double peak_megabytes();

std::int64_t process_number();

/// Whether two paths have the same characters; on Windows, case is ignored.
bool are_same_name(const std::filesystem::path& a, const std::filesystem::path& b);
/// Creates an empty file. \return `file_exists` if the name is taken
std::error_code make_new_file(const std::filesystem::path& file);
/// The reason why a file cannot be written, if any.
std::error_code write_access(const std::filesystem::path& file);
/// Flushes a file or folder to the disk.
std::error_code synchronize(const std::filesystem::path& path);
/// Renames a file, replacing an existing one, or a folder, replacing an empty one.
std::error_code replace(const std::filesystem::path& old_path, const std::filesystem::path& new_path);

} // namespace CGAL::Shape_correspondence::IO

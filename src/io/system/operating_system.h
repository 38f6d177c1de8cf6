// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

namespace CGAL::Shape_correspondence::IO {

// What is asked of the operating system beyond the standard library; posix.cpp and windows.cpp do it. Paths are UTF-8.

/// Prepares the streams, signals and memory of a program. \return the arguments of `main()` in UTF-8, without the name
std::vector<std::string> start_program(int argc, char* argv[]);

/// The file of this program; empty if it is not known.
std::filesystem::path program_file();

/// Whether standard error is a terminal that erases lines when asked to.
bool errors_are_on_terminal();

/// The most memory that the process has used.
double peak_megabytes();

std::int64_t process_number();

/// Whether two paths name one file, as far as their letters say: on Windows, large ones are as good as small ones.
bool are_same_name(const std::filesystem::path& a, const std::filesystem::path& b);
/// Makes an empty file. \return `file_exists` if there is anything of its name
std::error_code make_new_file(const std::filesystem::path& file);
/// Why a file cannot be written, if so.
std::error_code write_access(const std::filesystem::path& file);
/// Brings a file or folder to the disk.
std::error_code synchronize(const std::filesystem::path& path);
/// Renames a file, or a folder, which takes the place of a file or of an empty folder.
std::error_code replace(const std::filesystem::path& old_path, const std::filesystem::path& new_path);

} // namespace CGAL::Shape_correspondence::IO

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL::Shape_correspondence::IO {

/// Throws `Invalid_input` if there is neither a file nor a folder of this name; says why.
void check_exists(const std::string& path);

/// A file, opened for reading. \throw Invalid_input if it is not there, a folder, a pipe, or cannot be opened; names it
std::ifstream open_input(const std::string& path);

/// Whether a file or folder is one that folders have besides what people put there: `.name`, `__MACOSX`.
bool is_hidden(const std::filesystem::path& path);

/// Whether a text begins with a byte order mark of UTF-16.
bool is_wide_text(std::string_view text);

/// Throws `Invalid_input` if it does; names `file`.
void check_is_not_wide(std::string_view text, const std::string& file);

/// The files in a folder and its subfolders that are not hidden, sorted. \throw std::filesystem::filesystem_error if
/// one of these cannot be read; names it
std::vector<std::string> files_under(const std::string& folder);

/// Whether a file that `file` names is in the same folder as it, or in one of its sub-folders, also where links lead
/// to.
bool is_in_folder_of(const std::string& file, const std::string& named);

/// The extension of a file's name with its dot, in small letters; empty: none.
std::string lower_extension(const std::string& path);

} // namespace CGAL::Shape_correspondence::IO

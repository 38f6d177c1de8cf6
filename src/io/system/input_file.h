// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL::Shape_correspondence::IO {

/// Throws `Invalid_input` if there is neither a file nor a folder of this name; gives the reason.
void check_exists(const std::string& path);

/// Opens a file for reading. \throw Invalid_input if it is missing, a folder or a pipe, or cannot be opened; names it
std::ifstream open_input(const std::string& path);

/// Whether a file or folder is hidden or created by the system: `.name`, `__MACOSX`.
bool is_hidden(const std::filesystem::path& path);

/// Whether a text begins with a byte order mark of UTF-16.
bool is_wide_text(std::string_view text);

/// Throws `Invalid_input` if a text is in UTF-16; names `file`.
void check_is_not_wide(std::string_view text, const std::string& file);

/// The files in a folder and its sub-folders that are not hidden, sorted. \throw std::filesystem::filesystem_error if
/// one of these cannot be read; names it
std::vector<std::string> files_under(const std::string& folder);

/// Whether a file named by `file` is in the same folder or a sub-folder, after following links.
bool is_in_folder_of(const std::string& file, const std::string& named);

/// The extension of a file name with its dot, in lower case; empty: none.
std::string lower_extension(const std::string& path);

} // namespace CGAL::Shape_correspondence::IO

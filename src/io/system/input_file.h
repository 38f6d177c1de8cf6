// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <fstream>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::IO {

/// Throws `Invalid_input` if there is neither a file nor a folder of this name; says why.
void check_exists(const std::string& path);

/// A file, opened for reading. \throw Invalid_input if it is not there, a folder, a pipe, or cannot be opened; names it
std::ifstream open_input(const std::string& path);

/// The files in a folder and its subfolders, sorted. \throw std::filesystem::filesystem_error if one of these cannot be
/// read; names it
std::vector<std::string> files_under(const std::string& folder);

/// Whether a file that `file` names is in the same folder as it, or in one of its sub-folders, also where links lead
/// to.
bool is_in_folder_of(const std::string& file, const std::string& named);

/// The extension of a file's name with its dot, in small letters; empty: none.
std::string lower_extension(const std::string& path);

} // namespace CGAL::Shape_correspondence::IO

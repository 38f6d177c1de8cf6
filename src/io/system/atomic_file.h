// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>

namespace CGAL::Shape_correspondence::IO {

/// The file that is written for a path: where symbolic links lead to; it need not be there yet.
/// \throw Invalid_input if they lead in a circle; names the path
std::filesystem::path written_file(const std::string& path);

/// Throws `Invalid_input` if `path` cannot be written; to be called before long work, leaves nothing behind.
/// `-` is standard output.
void check_writable(const std::string& path);

/// Calls `write` and puts what it writes into the file `path`, all of it or nothing, also when the machine stops: under
/// a temporary name beside it first, which is then renamed. What is overwritten keeps its mode, and a symbolic
/// link leads on to it. Devices and pipes are written directly; `-` is standard output.
/// \throw Invalid_input if that fails; names the file
void write_atomically(const std::string& path, const std::function<void(std::ostream&)>& write);

/// The same for a file of a cache or store: what is in its place and no file, such as a pipe, is removed first.
void write_entry(const std::string& path, const std::function<void(std::ostream&)>& write);

/// Throws `Invalid_input` if the folder `path` cannot be made: where there is anything of that name but an empty
/// folder.
void check_new_folder(const std::string& path);

/// Calls `write` with a folder of a temporary name beside `path`, which is then renamed to `path`: all of it or
/// nothing. \throw Invalid_input if that fails; names the folder
void write_folder_atomically(const std::string& path, const std::function<void(const std::string&)>& write);

/// Removes the temporary files and folders of this process, which is about to end: it makes none any more.
void remove_temporaries();

/// Makes a folder if there is none. \param use what it is to be, "a store", for the user
/// \throw Invalid_input if that fails; names the folder
void make_folder(const std::string& path, const std::string& use);

} // namespace CGAL::Shape_correspondence::IO

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>

namespace CGAL::Shape_correspondence::IO {

/// The file that is written for a path, after following symbolic links; it need not exist.
/// \throw Invalid_input, naming the path, for a cycle of links
std::filesystem::path written_file(const std::string& path);

/// Throws `Invalid_input` if `path` is not writable; to be called before long work. `-` is standard output.
void check_writable(const std::string& path);

/// Calls `write` and puts the output into the file `path` atomically, even if the machine stops: it is written to a
/// temporary file next to `path`, which is then renamed. An overwritten file keeps its mode, and a symbolic link is
/// followed. Devices and pipes are written directly; `-` is standard output.
/// \throw Invalid_input, naming the file, on failure
void write_atomically(const std::string& path, const std::function<void(std::ostream&)>& write);

/// Writes a file of a cache or store atomically, after removing anything in its place that is not a file.
void write_entry(const std::string& path, const std::function<void(std::ostream&)>& write);

/// Throws `Invalid_input` if the folder `path` cannot be created: if the name is taken, except by an empty folder.
void check_new_folder(const std::string& path);

/// Calls `write` with a temporary folder next to `path`, which is then renamed to `path`, so that it appears complete
/// or not at all. \throw Invalid_input, naming the folder, on failure
void write_folder_atomically(const std::string& path, const std::function<void(const std::string&)>& write);

/// Removes the temporary files and folders of this process, which is about to end: no more can be made afterwards.
void remove_temporaries();

/// Creates a folder unless it exists. \param use purpose for messages, such as "a store"
/// \throw Invalid_input, naming the folder, on failure
void make_folder(const std::string& path, const std::string& use);

/// A digest (SHA-1) of bytes.
std::string digest(const std::string& bytes);

/// The content of a file; empty if it cannot be read, or is a pipe or a device.
std::string bytes_of_file(const std::string& path);

/// A *checked file* starts with a line with the title of its kind and a digest of its content. Several processes may
/// read and write it.

/// Writes a checked file atomically. \throw Invalid_input on failure
void write_checked_file(const std::string& path, const std::string& title, const std::string& content);

/// Writes a checked file as an entry of a cache or store, see `write_entry()`.
void write_checked_entry(const std::string& path, const std::string& title, const std::string& content);

/// The content of a checked file, given its entire text; none if it is damaged or has another title.
std::optional<std::string> checked_content(const std::string& file, const std::string& title);

/// The content of a checked file; none if it does not exist, is damaged or has another title.
std::optional<std::string> read_checked_file(const std::string& path, const std::string& title);

} // namespace CGAL::Shape_correspondence::IO

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <cctype>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL::Shape_correspondence::IO {

/// Remedies for kinds of faults. Every message about a file gives the error and, after a semicolon, a remedy.
namespace remedy {

constexpr const char* correct_text = "correct that place, or save the file again";
constexpr const char* save_again = "copy the file again, or save it again in the program that made it";
constexpr const char* check_kind = "check that it is the right file, and that its extension says what it is";
constexpr const char* check_name = "check its name";
constexpr const char* check_permissions = "check the path and its permissions";
constexpr const char* make_smaller = "simplify it, or divide it";
constexpr const char* save_as_other_format = "save it in another format, such as OBJ, PLY or GLB";
constexpr const char* install_again = "install the program again";
constexpr const char* write_elsewhere = "choose another place for the output";

} // namespace remedy

/// Whether a message has a remedy: a semicolon outside of quotes.
inline bool has_remedy(const std::string& message)
{
  bool is_quoted = false;
  for (std::size_t i = 0; i + 1 < message.size(); ++i) {
    if (message[i] == '\'') // a quotation mark; an apostrophe is between letters
      is_quoted = is_quoted ? std::isalnum(static_cast<unsigned char>(message[i + 1])) != 0
                            : i > 0 && !std::isalnum(static_cast<unsigned char>(message[i - 1]));
    if (!is_quoted && message[i] == ';' && message[i + 1] == ' ') return true;
  }
  return false;
}

/// The message with the remedy, unless it already has one.
inline std::string with_remedy(const std::string& message, const char* remedy)
{
  return has_remedy(message) ? message : message + "; " + remedy;
}

/// Throws `Invalid_input` with the message and, unless it already has one, the remedy.
[[noreturn]] inline void refuse(const std::string& message, const char* remedy)
{
  throw Invalid_input(with_remedy(message, remedy));
}

/// Throws `Invalid_input`, with the reason, if there is neither a file nor a folder of this name.
void check_exists(const std::string& path);

/// Opens a file for reading. \throw Invalid_input, naming the file, if it is missing, a folder or a pipe, or unreadable
std::ifstream open_input(const std::string& path);

/// Whether a file or folder is hidden or created by the system: `.name`, `__MACOSX`.
bool is_hidden(const std::filesystem::path& path);

/// Whether a text begins with a byte order mark of UTF-16.
bool is_wide_text(std::string_view text);

/// Throws `Invalid_input`, naming `file`, if its text is in UTF-16.
void check_is_not_wide(std::string_view text, const std::string& file);

/// The files in a folder and its sub-folders that are not hidden, sorted. \throw std::filesystem::filesystem_error,
/// naming the folder, if one of these cannot be read
std::vector<std::string> files_under(const std::string& folder);

/// Whether the file `named` is in the folder of `file` or a sub-folder of it, after following links.
bool is_in_folder_of(const std::string& file, const std::string& named);

/// The extension of a file name with its dot, in lower case; empty: none.
std::string lower_extension(const std::string& path);

} // namespace CGAL::Shape_correspondence::IO

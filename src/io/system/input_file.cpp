// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/system/input_file.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <boost/algorithm/string/case_conv.hpp>

#include <algorithm>
#include <locale>

namespace CGAL::Shape_correspondence::IO {

namespace fs = std::filesystem;

void check_exists(const std::string& path)
{
  std::error_code error; // no error if nothing has the name
  if (fs::exists(path, error)) return;
  if (error) refuse(path + ": it cannot be used (" + error.message() + ")", remedy::check_permissions);
  refuse(path + ": there is no such file or folder", remedy::check_name);
}

std::ifstream open_input(const std::string& path)
{
  check_exists(path);
  std::error_code error;
  if (fs::is_directory(path, error)) throw Invalid_input(path + ": it is a folder; name a file in it");
  if (fs::is_fifo(path, error)) // opening a pipe waits for a writer
    throw Invalid_input(path + ": it is a pipe; copy what it has into a file");
  std::ifstream in(fs::path(path), std::ios::binary);
  if (!in) throw Invalid_input(path + ": it cannot be opened for reading; check its permissions");
  return in;
}

bool is_hidden(const fs::path& path)
{
  const std::string name = path.filename().string();
  return name[0] == '.' || name == "__MACOSX";
}

bool is_wide_text(std::string_view text)
{
  const std::string_view mark = text.substr(0, 2);
  return mark == "\xFF\xFE" || mark == "\xFE\xFF";
}

void check_is_not_wide(std::string_view text, const std::string& file)
{
  if (is_wide_text(text)) throw Invalid_input(file + ": it is text in UTF-16; save it as UTF-8");
}

std::vector<std::string> files_under(const std::string& folder)
{
  std::vector<std::string> result;
  // Explicit recursion, since the recursive iterator does not tell which folder it cannot read
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (is_hidden(entry.path())) continue;
    if (entry.is_directory() && !entry.is_symlink()) {
      const std::vector<std::string> files = files_under(entry.path().string());
      result.insert(result.end(), files.begin(), files.end());
    } else if (entry.is_regular_file()) {
      result.push_back(entry.path().string());
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

bool is_in_folder_of(const std::string& file, const std::string& named)
{
  std::error_code error;
  const fs::path folder = fs::canonical(fs::absolute(file).parent_path(), error), path = fs::canonical(named, error);
  return !error && std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

std::string lower_extension(const std::string& path)
{
  return boost::algorithm::to_lower_copy(fs::path(path).extension().string(), std::locale::classic());
}

} // namespace CGAL::Shape_correspondence::IO

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/input_file.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <boost/algorithm/string/case_conv.hpp>

#include <filesystem>
#include <locale>

namespace CGAL::Shape_correspondence::IO {

namespace fs = std::filesystem;

std::ifstream open_input(const std::string& path)
{
  std::error_code error;
  if (!fs::exists(path, error)) throw Invalid_input(path + ": there is no such file or folder");
  if (fs::is_directory(path, error)) throw Invalid_input(path + ": it is a folder; name a file in it");
  std::ifstream in(path, std::ios::binary);
  if (!in) throw Invalid_input(path + ": it cannot be opened for reading; check its permissions");
  return in;
}

std::string lower_extension(const std::string& path)
{
  return boost::algorithm::to_lower_copy(fs::path(path).extension().string(), std::locale::classic());
}

} // namespace CGAL::Shape_correspondence::IO

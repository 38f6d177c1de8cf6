// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/data_folder.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <filesystem>

namespace CGAL::Shape_correspondence::cli {

std::string data_folder()
{
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error); // empty where there is no such file
  const fs::path installed = program.parent_path().parent_path() / SHAPE_CORRESPONDENCE_INSTALLED_DATA;
  for (const fs::path& folder : {installed, fs::path(SHAPE_CORRESPONDENCE_SOURCE_DATA)})
    if (fs::is_directory(folder, error)) return folder.string();
  throw Invalid_input(installed.string() + ": the models that come with the program are not there; reinstall it");
}

} // namespace CGAL::Shape_correspondence::cli

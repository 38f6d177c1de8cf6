// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read/model_parts.h"
#include "io/system/input_file.h"
#include "io/system/quoting.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace CGAL::Shape_correspondence::IO {
namespace {

namespace fs = std::filesystem;

std::string with_slashes(std::string name)
{
  std::replace(name.begin(), name.end(), '\\', '/');
  return name;
}

} // namespace

Named_file Named_files::read(const std::string& given) const
{
  const fs::path folder = fs::path(model).parent_path();
  const std::string name = with_slashes(given);
  std::error_code error;
  std::string fault = "is not there";
  for (const fs::path candidate : {name, percent_decoded(name)})
    for (const fs::path& path : {folder / candidate.relative_path(), folder / candidate.filename()}) {
      if (!fs::is_regular_file(path, error)) continue;
      if (!options.allow_outside_files && !is_in_folder_of(model, path.string())) {
        fault = "is outside the model's folder, and not read without --allow-outside-files";
        continue;
      }
      const std::uintmax_t size = fs::file_size(path, error);
      if (size > largest) return {"", "is larger than " + std::to_string(largest >> 20) + " MB"};
      if (size > rest) return {"", "is more than a model may have in such files"};
      std::ifstream in(path, std::ios::binary);
      Named_file result{std::string(std::size_t(size), '\0'), in ? "" : "cannot be read"};
      in.read(result.bytes.data(), std::streamsize(size));
      result.bytes.resize(std::size_t(in.gcount()));
      rest -= std::min<std::uintmax_t>(rest, result.bytes.size());
      return result;
    }
  return {"", fault};
}

} // namespace CGAL::Shape_correspondence::IO

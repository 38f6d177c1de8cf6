// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/outputs.h"
#include "cli/Common_options.h"
#include "io/atomic_file.h"

#include <set>

namespace CGAL::Shape_correspondence::cli {

void check_outputs(const std::vector<std::string>& files)
{
  std::set<std::string> outputs;
  for (const std::string& file : files) {
    if (file.empty()) continue;
    if (!outputs.insert(file).second) throw Usage_error("two outputs are the same file, " + file);
    IO::check_writable(file);
  }
}

void write_output(const std::string& file, const std::function<void(std::ostream&)>& write)
{
  if (!file.empty()) IO::write_atomically(file, write);
}

} // namespace CGAL::Shape_correspondence::cli

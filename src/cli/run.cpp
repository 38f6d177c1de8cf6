// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/run.h"
#include "base/for_each_index.h"
#include "cli/text.h"
#include "io/system/atomic_file.h"
#include "io/system/operating_system.h"
#include "io/system/quoting.h"

#include <chrono>
#include <filesystem>
#include <iostream>

namespace CGAL::Shape_correspondence::cli {
namespace {

namespace fs = std::filesystem;

/// Whether two paths lead to the same file, or would if it were there.
bool are_same_file(const std::string& a, const std::string& b)
{
  std::error_code error;
  if (fs::exists(a, error) && fs::exists(b, error)) return fs::equivalent(a, b, error);
  const auto place = [&](const std::string& path) {
    return fs::weakly_canonical(fs::absolute(IO::written_file(path), error), error);
  };
  return a == b || IO::are_same_name(place(a), place(b));
}

} // namespace

void check_outputs(const std::vector<std::string>& files, const std::vector<std::string>& inputs)
{
  std::vector<std::string> outputs;
  for (const std::string& file : files) {
    if (file.empty()) continue;
    for (const std::string& other : outputs)
      if (are_same_file(file, other)) throw Usage_error("two outputs are the same file, " + file);
    for (const std::string& input : inputs)
      if (file != "-" && !input.empty() && are_same_file(file, input))
        throw Usage_error("the output " + file + " is an input, too");
    outputs.push_back(file);
    IO::check_writable(file);
  }
}

void write_output(const std::string& file, const std::function<void(std::ostream&)>& write)
{
  if (!file.empty()) IO::write_atomically(file, write);
}

void warn(const Common_options& options, const std::string& message)
{
  if (!options.quiet) std::cerr << "shape_correspondence: note: " + IO::quote_terminal(message) + '\n';
}

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

Thread_limit::Thread_limit(int threads) : control_(threads > 0 ? internal::limit_threads(threads) : nullptr) {}

Run_report::~Run_report()
{
  if (enabled_)
    std::cerr << "shape_correspondence: " << short_number(now() - begin_) << " s, at most "
              << short_number(IO::peak_megabytes()) << " MB\n";
}

} // namespace CGAL::Shape_correspondence::cli

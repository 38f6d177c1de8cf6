// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/run.h"
#include "cli/text.h"
#include "io/system/atomic_file.h"
#include "io/system/quoting.h"

#include <chrono>
#include <filesystem>
#include <iostream>
#include <sys/resource.h>
#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

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
  return a == b || place(a) == place(b);
}

/// The most memory that the process has used. Linux counts it in kilobytes.
double peak_megabytes()
{
  constexpr double kilobytes = 1024;
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return double(usage.ru_maxrss) / kilobytes;
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

Thread_limit::Thread_limit([[maybe_unused]] int threads)
{
#ifdef CGAL_LINKED_WITH_TBB
  if (threads > 0)
    control_ = std::make_shared<tbb::global_control>(tbb::global_control::max_allowed_parallelism, threads);
#endif
}

Run_report::~Run_report()
{
  if (enabled_)
    std::cerr << "shape_correspondence: " << short_number(now() - begin_) << " s, at most "
              << short_number(peak_megabytes()) << " MB\n";
}

} // namespace CGAL::Shape_correspondence::cli

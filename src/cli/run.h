// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "cli/Common_options.h"

#include <cstddef>
#include <functional>
#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::cli {

/// Clears the list of written outputs.
void start_outputs();

/// Writes an output file atomically; does nothing if `file` is empty.
/// \throw Invalid_input on failure; names the outputs that were written before
void write_output(const std::string& file, const std::function<void(std::ostream&)>& write);

/// Records an output that was written in another way.
void output_is_whole(const std::string& file);

/// Prints a warning to standard error unless the options are quiet.
void warn(const Common_options& options, const std::string& message);

/// Wall-clock time in seconds since an arbitrary moment.
double now();

/// Limits the number of working threads as long as the result lives; 0: no limit.
std::shared_ptr<void> limit_threads(int threads);

/// A progress bar on standard error that shows the estimated remaining time after two seconds, and is erased at the
/// end. If the options have a function for progress, that is called instead.
class Progress_bar
{
public:
  /// \param unit name of the counted items
  Progress_bar(const Common_options& options, std::string label, std::string unit = "part");
  ~Progress_bar();
  Progress_bar(const Progress_bar&) = delete;
  Progress_bar& operator=(const Progress_bar&) = delete;

  void show(std::size_t done, std::size_t total);

private:
  bool enabled_;
  bool shown_ = false;
  std::function<void(const std::string&, std::size_t, std::size_t)> on_progress_;
  std::string label_, unit_;
  double begin_, last_shown_ = 0; // seconds
};

} // namespace CGAL::Shape_correspondence::cli

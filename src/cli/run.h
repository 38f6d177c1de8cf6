// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "cli/Common_options.h"

#include <functional>
#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::cli {

/// Checks output files before long work; empty ones are not asked for. `-` is standard output.
/// \param inputs files and folders that are read
/// \throw Usage_error if two are the same file, however they are spelt, or one is an input; Invalid_input if one cannot
/// be written
void check_outputs(const std::vector<std::string>& files, const std::vector<std::string>& inputs);

/// Writes an output file, all of it or nothing; none if it is not asked for. \throw Invalid_input if that fails
void write_output(const std::string& file, const std::function<void(std::ostream&)>& write);

/// Warns on standard error, unless the options are to be quiet.
void warn(const Common_options& options, const std::string& message);

/// Seconds on the wall since some moment.
double now();

/// While it lives, no more threads work than this; 0 sets no limit.
class Thread_limit
{
public:
  explicit Thread_limit(int threads);

private:
  std::shared_ptr<void> control_;
};

/// Prints at its end what the command took, if that is asked for: time and memory, on standard error.
class Run_report
{
public:
  explicit Run_report(const Common_options& options) : enabled_(options.verbose), begin_(now()) {}
  ~Run_report();
  Run_report(const Run_report&) = delete;
  Run_report& operator=(const Run_report&) = delete;

private:
  bool enabled_;
  double begin_;
};

} // namespace CGAL::Shape_correspondence::cli

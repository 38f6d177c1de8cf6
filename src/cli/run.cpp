// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/run.h"
#include "base/for_each_index.h"
#include "cli/text.h"
#include "io/system/atomic_file.h"
#include "io/system/operating_system.h"
#include "io/system/quoting.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <chrono>
#include <cmath>
#include <iostream>
#include <vector>

namespace CGAL::Shape_correspondence::cli {
namespace {

constexpr std::size_t bar_width = 30;
constexpr const char* erase_line = "\r\033[K";
constexpr double interval = 0.1; // seconds
constexpr double moment = 2;     // seconds before the remaining time is estimated

std::string time_text(double seconds)
{
  const long s = std::lround(seconds);
  if (s < 60) return std::to_string(s) + " s";
  if (s < 3600) return std::to_string(s / 60) + " min " + std::to_string(s % 60) + " s";
  return std::to_string(s / 3600) + " h " + std::to_string(s % 3600 / 60) + " min";
}

bool is_enabled(const Common_options& options)
{
  if (options.quiet || options.progress == "never") return false;
  return options.progress == "always" || IO::errors_are_on_terminal();
}

/// The outputs written by the command so far, for the message if another one fails.
std::vector<std::string>& whole_outputs()
{
  static std::vector<std::string> result;
  return result;
}

} // namespace

void start_outputs() { whole_outputs().clear(); }

void write_output(const std::string& file, const std::function<void(std::ostream&)>& write)
{
  if (file.empty()) return;
  try {
    IO::write_atomically(file, write);
  } catch (const Invalid_input& error) {
    if (whole_outputs().empty()) throw;
    throw Invalid_input(error.what() + ("; what was written before is whole: " + listed(whole_outputs())));
  }
  output_is_whole(file);
}

void output_is_whole(const std::string& file) { whole_outputs().push_back(file == "-" ? "standard output" : file); }

void warn(const Common_options& options, const std::string& message)
{
  if (!options.quiet) std::cerr << "shape_correspondence: note: " + IO::quote_terminal(message) + '\n';
}

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

std::shared_ptr<void> limit_threads(int threads) { return threads > 0 ? internal::limit_threads(threads) : nullptr; }

Progress_bar::Progress_bar(const Common_options& options, std::string label, std::string unit)
    : enabled_(is_enabled(options)),
      on_progress_(options.on_progress),
      label_(IO::quote_terminal(label)),
      unit_(std::move(unit)),
      begin_(now())
{}

Progress_bar::~Progress_bar()
{
  if (shown_) std::cerr << erase_line << std::flush;
}

void Progress_bar::show(std::size_t done, std::size_t total)
{
  if (on_progress_) return on_progress_(label_, done, total);
  const double time = now();
  if (!enabled_ || total == 0 || (shown_ && done < total && time - last_shown_ < interval)) return;
  const std::size_t filled = bar_width * done / total;
  std::cerr << erase_line << '[' << std::string(filled, '#') << std::string(bar_width - filled, '.') << "] " << label_
            << ": " << unit_ << ' ' << done << " of " << total;
  const double left = done > 0 ? (time - begin_) * double(total - done) / double(done) : 0;
  if (time - begin_ > moment && done < total) std::cerr << ", " << time_text(left) << " left";
  std::cerr << std::flush;
  last_shown_ = time;
  shown_ = true;
}

} // namespace CGAL::Shape_correspondence::cli

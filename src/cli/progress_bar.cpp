// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "progress_bar.h"

#include <unistd.h>

#include <iostream>

namespace CGAL {
namespace Shape_correspondence {
namespace cli {
namespace {

constexpr std::size_t bar_width = 30;
constexpr const char* erase_line = "\r\033[K";

bool is_enabled(const Common_options& options)
{
  if (options.quiet || options.progress == "never") return false;
  return options.progress == "always" || isatty(STDERR_FILENO);
}

} // namespace

Progress_bar::Progress_bar(const Common_options& options, std::string label)
    : enabled_(is_enabled(options)), label_(std::move(label))
{}

Progress_bar::~Progress_bar()
{
  if (shown_) std::cerr << erase_line << std::flush;
}

void Progress_bar::show(std::size_t done, std::size_t total)
{
  if (!enabled_ || total == 0) return;
  const std::size_t filled = bar_width * done / total;
  std::cerr << erase_line << '[' << std::string(filled, '#') << std::string(bar_width - filled, '.') << "] " << label_
            << ": part " << done << " of " << total << std::flush;
  shown_ = true;
}

} // namespace cli
} // namespace Shape_correspondence
} // namespace CGAL

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "cli/Common_options.h"

#include <cstddef>
#include <functional>
#include <string>

namespace CGAL::Shape_correspondence::cli {

/// A progress bar on standard error, with the estimated time left after the first two seconds; it is erased at the end.
/// If the options have a function for progress, that is called instead.
class Progress_bar
{
public:
  /// \param unit name of the items counted
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

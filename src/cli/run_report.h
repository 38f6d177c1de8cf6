// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "cli/Common_options.h"

namespace CGAL::Shape_correspondence::cli {

/// Prints at its end what the command took, if that is asked for: time and memory, on standard error.
class Run_report
{
public:
  explicit Run_report(const Common_options& options);
  ~Run_report();
  Run_report(const Run_report&) = delete;
  Run_report& operator=(const Run_report&) = delete;

private:
  bool enabled_;
  double begin_; // seconds
};

} // namespace CGAL::Shape_correspondence::cli

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/run_report.h"
#include "cli/clock.h"
#include "cli/text_table.h"

#include <iostream>
#include <sys/resource.h>

namespace CGAL::Shape_correspondence::cli {
namespace {

/// The most memory that the process has used. Linux counts it in kilobytes.
double peak_megabytes()
{
  constexpr double kilobytes = 1024;
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return double(usage.ru_maxrss) / kilobytes;
}

} // namespace

Run_report::Run_report(const Common_options& options) : enabled_(options.verbose), begin_(now()) {}

Run_report::~Run_report()
{
  if (enabled_)
    std::cerr << "shape_correspondence: " << short_number(now() - begin_) << " s, at most "
              << short_number(peak_megabytes()) << " MB\n";
}

} // namespace CGAL::Shape_correspondence::cli

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_CLI_CLOCK_H
#define CGAL_SHAPE_CORRESPONDENCE_CLI_CLOCK_H

#include <chrono>

namespace CGAL {
namespace Shape_correspondence {
namespace cli {

/// Seconds on the wall since some moment.
inline double now()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

} // namespace cli
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_CLI_CLOCK_H

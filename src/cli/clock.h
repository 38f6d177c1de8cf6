// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <chrono>

namespace CGAL::Shape_correspondence::cli {

/// Seconds on the wall since some moment.
inline double now()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

} // namespace CGAL::Shape_correspondence::cli

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_CLI_THREAD_LIMIT_H
#define CGAL_SHAPE_CORRESPONDENCE_CLI_THREAD_LIMIT_H

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>

#include <optional>

#endif

namespace CGAL {
namespace Shape_correspondence {
namespace cli {

/// While it lives, no more threads work than this; 0 sets no limit.
class Thread_limit
{
public:
#ifdef CGAL_LINKED_WITH_TBB
  explicit Thread_limit(int threads)
  {
    if (threads > 0) control_.emplace(tbb::global_control::max_allowed_parallelism, threads);
  }

private:
  std::optional<tbb::global_control> control_;
#else
  explicit Thread_limit(int) {}
#endif
};

} // namespace cli
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_CLI_THREAD_LIMIT_H

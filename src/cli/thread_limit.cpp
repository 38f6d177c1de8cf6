// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/thread_limit.h"

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

namespace CGAL::Shape_correspondence::cli {

Thread_limit::Thread_limit(int threads)
{
#ifdef CGAL_LINKED_WITH_TBB
  if (threads > 0)
    control_ = std::make_shared<tbb::global_control>(tbb::global_control::max_allowed_parallelism, threads);
#else
  static_cast<void>(threads);
#endif
}

} // namespace CGAL::Shape_correspondence::cli

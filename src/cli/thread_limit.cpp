// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/thread_limit.h"

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

namespace CGAL {
namespace Shape_correspondence {
namespace cli {

Thread_limit::Thread_limit(int threads)
{
#ifdef CGAL_LINKED_WITH_TBB
  if (threads > 0)
    control_ = std::make_shared<tbb::global_control>(tbb::global_control::max_allowed_parallelism, threads);
#else
  static_cast<void>(threads);
#endif
}

} // namespace cli
} // namespace Shape_correspondence
} // namespace CGAL

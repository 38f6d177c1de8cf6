// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/for_each_index.h"

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#endif

namespace CGAL::Shape_correspondence::internal {

void for_each_index(std::size_t n, bool parallel, const std::function<void(std::size_t)>& work)
{
#ifdef CGAL_LINKED_WITH_TBB
  if (parallel) {
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, n, 1),
        [&](const auto& range) {
          for (std::size_t i = range.begin(); i != range.end(); ++i)
            work(i);
        },
        tbb::simple_partitioner());
    return;
  }
#else
  static_cast<void>(parallel);
#endif
  for (std::size_t i = 0; i < n; ++i)
    work(i);
}

} // namespace CGAL::Shape_correspondence::internal

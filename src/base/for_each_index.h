// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_BASE_FOR_EACH_INDEX_H
#define CGAL_SHAPE_CORRESPONDENCE_BASE_FOR_EACH_INDEX_H

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#endif

#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

/// Calls `work` for 0, 1, …, n - 1, in parallel if the tag says so and the library is there.
template <typename ConcurrencyTag, typename Work>
void for_each_index(std::size_t n, const Work& work)
{
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr (std::is_convertible_v<ConcurrencyTag, CGAL::Parallel_tag>) {
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, n, 1),
        [&](const auto& range) {
          for (std::size_t i = range.begin(); i != range.end(); ++i) {
            work(i);
          }
        },
        tbb::simple_partitioner());
    return;
  }
#endif
  for (std::size_t i = 0; i < n; ++i) {
    work(i);
  }
}

} // namespace internal
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_BASE_FOR_EACH_INDEX_H

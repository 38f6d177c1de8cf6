// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/tags.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <type_traits>

namespace CGAL::Shape_correspondence::internal {

/// Calls `work` for 0, 1, …, n - 1; if `parallel`, concurrently, by TBB where available. After a call throws, calls
/// with greater numbers may be skipped; when all calls have ended, the exception of the lowest number is thrown. Loops
/// within `work` complete whatever happens in other calls.
void for_each_index(std::size_t n, bool parallel, const std::function<void(std::size_t)>& work);

/// Calls `work` for 0, 1, …, n - 1, in parallel if the tag is `CGAL::Parallel_tag`.
template <typename ConcurrencyTag>
void for_each_index(std::size_t n, const std::function<void(std::size_t)>& work)
{
  for_each_index(n, std::is_convertible_v<ConcurrencyTag, CGAL::Parallel_tag>, work);
}

/// Limits the number of working threads as long as the result lives.
std::shared_ptr<void> limit_threads(int threads);

} // namespace CGAL::Shape_correspondence::internal

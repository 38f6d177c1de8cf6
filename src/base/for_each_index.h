// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/tags.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <type_traits>

namespace CGAL::Shape_correspondence::internal {

/// Calls `work` for 0, 1, …, n - 1; `parallel`: several at a time, by TBB where it is there. After a call that throws,
/// those of greater numbers may be left out; the exception of the least number that failed is thrown when all calls
/// have ended. Loops in `work` run to their end whatever happens in other calls.
void for_each_index(std::size_t n, bool parallel, const std::function<void(std::size_t)>& work);

/// The same, in parallel if the tag says so.
template <typename ConcurrencyTag>
void for_each_index(std::size_t n, const std::function<void(std::size_t)>& work)
{
  for_each_index(n, std::is_convertible_v<ConcurrencyTag, CGAL::Parallel_tag>, work);
}

/// While the result lives, no more threads than this work at a time.
std::shared_ptr<void> limit_threads(int threads);

} // namespace CGAL::Shape_correspondence::internal

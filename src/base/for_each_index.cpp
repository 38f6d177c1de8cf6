// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/for_each_index.h"

// The thread sanitizer does not see how tasks of TBB wait for each other, since its library is compiled without it
#if defined(__SANITIZE_THREAD__)
#define SHAPE_CORRESPONDENCE_PLAIN_THREADS
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define SHAPE_CORRESPONDENCE_PLAIN_THREADS
#endif
#endif

#ifdef SHAPE_CORRESPONDENCE_PLAIN_THREADS
#include <array>
#include <exception>
#include <thread>
#include <vector>
#elif defined(CGAL_LINKED_WITH_TBB)
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#endif

namespace CGAL::Shape_correspondence::internal {
namespace {

#ifdef SHAPE_CORRESPONDENCE_PLAIN_THREADS
void run_in_parallel(std::size_t n, const std::function<void(std::size_t)>& work)
{
  constexpr std::size_t number_of_threads = 4;
  std::array<std::exception_ptr, number_of_threads> failures;
  std::vector<std::thread> threads;
  for (std::size_t first = 0; first < number_of_threads; ++first)
    threads.emplace_back([&, first] { // every thread has its share, however soon another ends
      try {
        for (std::size_t i = first; i < n; i += number_of_threads)
          work(i);
      } catch (...) {
        failures[first] = std::current_exception();
      }
    });
  for (std::thread& thread : threads)
    thread.join();
  for (const std::exception_ptr& failure : failures)
    if (failure) std::rethrow_exception(failure);
}
#elif defined(CGAL_LINKED_WITH_TBB)
void run_in_parallel(std::size_t n, const std::function<void(std::size_t)>& work)
{
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, n, 1),
      [&](const auto& range) {
        for (std::size_t i = range.begin(); i != range.end(); ++i)
          work(i);
      },
      tbb::simple_partitioner());
}
#else
void run_in_parallel(std::size_t n, const std::function<void(std::size_t)>& work)
{
  for (std::size_t i = 0; i < n; ++i)
    work(i);
}
#endif

} // namespace

void for_each_index(std::size_t n, bool parallel, const std::function<void(std::size_t)>& work)
{
  if (parallel && n > 1) return run_in_parallel(n, work);
  for (std::size_t i = 0; i < n; ++i)
    work(i);
}

} // namespace CGAL::Shape_correspondence::internal

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/for_each_index.h"

// TBB is compiled without the thread sanitizer, which therefore does not see how its tasks wait for each other
#if defined(__SANITIZE_THREAD__)
#define SHAPE_CORRESPONDENCE_PLAIN_THREADS
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define SHAPE_CORRESPONDENCE_PLAIN_THREADS
#endif
#endif

#include <atomic>
#include <exception>
#include <limits>
#include <mutex>
#include <thread>
#include <vector>
#ifdef CGAL_LINKED_WITH_TBB
#include <stdexcept>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_group.h>
#else
#include <algorithm>
#include <system_error>
#endif

namespace CGAL::Shape_correspondence::internal {
namespace {

/// Of all exceptions, the one that a sequential loop would meet first.
class First_failure
{
public:
  bool is_before(std::size_t i) const { return index_ < i; }

  void keep(std::size_t i, std::exception_ptr failure)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (i >= index_) return;
    index_ = i;
    failure_ = std::move(failure);
  }

  void rethrow() const
  {
    if (failure_) std::rethrow_exception(failure_);
  }

private:
  std::atomic<std::size_t> index_{std::numeric_limits<std::size_t>::max()};
  std::exception_ptr failure_;
  std::mutex mutex_;
};

#ifdef SHAPE_CORRESPONDENCE_PLAIN_THREADS
constexpr bool is_caller_alone() { return false; }

template <typename Work>
void run_in_parallel(std::size_t n, const Work& work)
{
  constexpr std::size_t number_of_threads = 4;
  std::vector<std::thread> threads;
  for (std::size_t first = 0; first < number_of_threads; ++first)
    threads.emplace_back([&, first] { // each thread has a fixed share, even if others end early
      for (std::size_t i = first; i < n; i += number_of_threads)
        work(i);
    });
  for (std::thread& thread : threads)
    thread.join();
}
#elif defined(CGAL_LINKED_WITH_TBB)
/// Whether only the caller may work: TBB would start a thread nevertheless, and terminates the program if it cannot.
bool is_caller_alone() { return tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism) < 2; }

template <typename Work>
void run_in_parallel(std::size_t n, const Work& work)
{
  // An isolated context: an enclosing loop's would silently skip calls of this loop when it is cancelled
  tbb::task_group_context group(tbb::task_group_context::isolated);
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, n, 1),
      [&](const auto& range) {
        for (std::size_t i = range.begin(); i != range.end(); ++i)
          work(i);
      },
      tbb::simple_partitioner(), group);
  if (group.is_group_execution_cancelled()) throw std::runtime_error("a parallel loop was cancelled");
}
#else
/// Number of threads that may work, and number of those that are idle. Threads that could not be created, as in a
/// browser, never count as idle again.
std::atomic<int> working_threads{std::max(1, int(std::thread::hardware_concurrency()))},
    idle_threads{working_threads - 1};

constexpr std::size_t most_taken = 1024;           // limit of the threads that one loop starts
constexpr bool is_caller_alone() { return false; } // a loop that finds no idle thread starts none

/// Takes idle threads for a loop. \return their number, at most `most`
int take_idle_threads(int most)
{
  int idle = idle_threads, taken = 0;
  do
    taken = std::clamp(idle, 0, most);
  while (!idle_threads.compare_exchange_weak(idle, idle - taken));
  return taken;
}

/// Works in idle threads and in the calling one, so that a nested loop proceeds even if no thread is idle.
template <typename Work>
void run_in_parallel(std::size_t n, const Work& work)
{
  std::atomic<std::size_t> next{0};
  const auto run = [&] {
    for (std::size_t i = next++; i < n; i = next++)
      work(i);
  };
  std::vector<std::thread> threads;
  try {
    for (int taken = take_idle_threads(int(std::min<std::size_t>(n, most_taken)) - 1); taken > 0; --taken)
      threads.emplace_back([&] {
        run();
        ++idle_threads;
      });
  } catch (const std::system_error&) { // no more threads can be made
  }
  run();
  for (std::thread& thread : threads)
    thread.join();
}
#endif

} // namespace

void for_each_index(std::size_t n, bool parallel, const std::function<void(std::size_t)>& work)
{
  if (!parallel || n < 2 || is_caller_alone()) {
    for (std::size_t i = 0; i < n; ++i)
      work(i);
    return;
  }
  First_failure failure; // caught here, since an exception that leaves a task would cancel enclosing loops
  run_in_parallel(n, [&](std::size_t i) {
    if (failure.is_before(i)) return;
    try {
      work(i);
    } catch (...) {
      failure.keep(i, std::current_exception());
    }
  });
  failure.rethrow();
}

std::shared_ptr<void> limit_threads([[maybe_unused]] int threads)
{
#ifdef SHAPE_CORRESPONDENCE_PLAIN_THREADS
  return nullptr;
#elif defined(CGAL_LINKED_WITH_TBB)
  return std::make_shared<tbb::global_control>(tbb::global_control::max_allowed_parallelism, threads);
#else
  const int less = working_threads.exchange(threads) - threads;
  idle_threads -= less;
  return {nullptr, [less](std::nullptr_t) {
            idle_threads += less;
            working_threads += less;
          }};
#endif
}

} // namespace CGAL::Shape_correspondence::internal

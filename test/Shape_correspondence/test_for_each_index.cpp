// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/for_each_index.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/parallel_for.h>
#include <tbb/task.h>
#endif

using CGAL::Shape_correspondence::internal::for_each_index;
using CGAL::Shape_correspondence::internal::limit_threads;

namespace {

constexpr std::size_t outer = 16, inner = 64, first_bad = 5, second_bad = 6;
constexpr int runs = 200;

/// Number of calls of nested loops, by index of the outer call; some outer calls throw after their loop.
std::vector<std::size_t> calls_of_nested_loops(std::string& failure)
{
  std::vector<std::size_t> calls(outer, 0);
  try {
    for_each_index(outer, true, [&](std::size_t i) {
      std::vector<int> is_called(inner, 0);
      if (i != first_bad) for_each_index(inner, true, [&](std::size_t k) { is_called[k] = 1; });
      for (int called : is_called)
        calls[i] += std::size_t(called);
      if (i == first_bad || i == second_bad) throw std::runtime_error(std::to_string(i));
    });
  } catch (const std::runtime_error& error) {
    failure = error.what();
  }
  return calls;
}

} // namespace

TEST_CASE("A call that throws does not interrupt loops in other calls, and the first exception is rethrown")
{
  for (int threads : {1, 2, 8}) {
    const std::shared_ptr<void> limit = limit_threads(threads);
    INFO(threads << " threads");
    for (int run = 0; run < runs; ++run) {
      std::string failure;
      const std::vector<std::size_t> calls = calls_of_nested_loops(failure);
      REQUIRE(failure == std::to_string(first_bad));
      for (std::size_t i = 0; i < outer; ++i) {
        if (i < first_bad) REQUIRE(calls[i] == inner);
        REQUIRE((calls[i] == inner || calls[i] == 0));
      }
    }
  }
}

#ifndef __SANITIZE_THREAD__
TEST_CASE("As many threads work as the limit allows, also in nested loops, and as before when it is removed")
{
  const auto most_at_once = [] {
    std::atomic<int> working{0}, most{0};
    for_each_index(outer, true, [&](std::size_t) {
      for_each_index(4, true, [&](std::size_t) {
        const int now = ++working;
        for (int known = most; known < now && !most.compare_exchange_weak(known, now);)
          ;
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        --working;
      });
    });
    return int(most);
  };
  const int all = most_at_once();
  CHECK(all <= std::max(1, int(std::thread::hardware_concurrency())));
  for (int threads : {1, 2}) {
    const std::shared_ptr<void> limit = limit_threads(threads);
    CHECK(most_at_once() <= threads);
    const std::shared_ptr<void> narrower = limit_threads(1);
    CHECK(most_at_once() == 1);
  }
  CHECK(most_at_once() == all);
}
#endif

TEST_CASE("With a limit of one, no thread but the caller's works")
{
  const std::shared_ptr<void> limit = limit_threads(1);
  std::vector<std::thread::id> threads(outer);
  for_each_index(outer, true, [&](std::size_t i) { threads[i] = std::this_thread::get_id(); });
  CHECK(std::count(threads.begin(), threads.end(), std::this_thread::get_id()) == std::ptrdiff_t(outer));
#ifdef CGAL_LINKED_WITH_TBB
  for_each_index(2, true, [](std::size_t) { CHECK(tbb::task::current_context() == nullptr); }); // runs without TBB
#endif
}

TEST_CASE("A loop in sequence ends with the call that throws")
{
  std::size_t calls = 0;
  CHECK_THROWS_AS(for_each_index(10, false,
                                 [&](std::size_t i) {
                                   ++calls;
                                   if (i == 3) throw std::runtime_error("");
                                 }),
                  std::runtime_error);
  CHECK(calls == 4);
}

#if defined(CGAL_LINKED_WITH_TBB) && !defined(__SANITIZE_THREAD__)
TEST_CASE("A caller that cancels its own loop does not cut short loops in it")
{
  for (int run = 0; run < runs; ++run) {
    std::vector<std::size_t> calls(outer, 0);
    tbb::parallel_for(std::size_t(0), outer, [&](std::size_t i) {
      std::vector<int> is_called(inner, 0);
      if (i == first_bad) tbb::task::current_context()->cancel_group_execution();
      for_each_index(inner, true, [&](std::size_t k) { is_called[k] = 1; });
      for (int called : is_called)
        calls[i] += std::size_t(called);
    });
    for (std::size_t n : calls)
      REQUIRE((n == inner || n == 0));
  }
}

TEST_CASE("A loop that is cancelled from inside is an error")
{
  if (std::thread::hardware_concurrency() < 2) return; // a single processor runs no parallel loop to cancel
  const auto cancel = [](std::size_t) { tbb::task::current_context()->cancel_group_execution(); };
  CHECK_THROWS_WITH(for_each_index(inner, true, cancel), Catch::Matchers::Contains("cancelled"));
}
#endif

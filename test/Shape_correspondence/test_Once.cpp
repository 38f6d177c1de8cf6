// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/Once.h"

#include <catch2/catch.hpp>

#include <atomic>
#include <stdexcept>
#include <thread>
#include <vector>

using CGAL::Shape_correspondence::internal::Once;

TEST_CASE("Work is done once, and finished before any of the threads continues")
{
  constexpr int rounds = 200, number_of_threads = 4;
  for (int round = 0; round < rounds; ++round) {
    Once once;
    std::atomic<int> times{0}, ready{0}, unfinished{0};
    std::vector<int> result; // not atomic: the lock must make writes visible
    std::vector<std::thread> threads;
    for (int i = 0; i < number_of_threads; ++i)
      threads.emplace_back([&] {
        ++ready;
        while (ready < number_of_threads)
          std::this_thread::yield();
        once([&] {
          ++times;
          result.assign(1000, round);
        });
        if (result.size() != 1000 || result.back() != round) ++unfinished;
      });
    for (std::thread& thread : threads)
      thread.join();
    REQUIRE(times == 1);
    REQUIRE(unfinished == 0);
  }
}

TEST_CASE("Work that failed is repeated by the next thread that asks for it")
{
  Once once;
  int times = 0;
  CHECK_THROWS_AS(once([] { throw std::runtime_error("failed"); }), std::runtime_error);
  once([&] { ++times; });
  once([&] { ++times; });
  CHECK(times == 1);
}

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <atomic>
#include <mutex>

namespace CGAL::Shape_correspondence::internal {

/// Runs work once, in the first thread that asks for it; other threads wait for its end. Unlike `std::call_once()`, it
/// makes no system call for the first run, which would take as long as computing the rods of a contact.
class Once
{
public:
  template <typename Work>
  void operator()(const Work& work)
  {
    if (is_done_.load(std::memory_order_acquire)) return;
    const std::lock_guard<std::mutex> lock(mutex_);
    if (is_done_.load(std::memory_order_relaxed)) return;
    work();
    is_done_.store(true, std::memory_order_release);
  }

private:
  std::atomic<bool> is_done_{false};
  std::mutex mutex_;
};

} // namespace CGAL::Shape_correspondence::internal

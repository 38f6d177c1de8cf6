// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/energy_matrix.h>

#include <atomic>
#include <cmath>
#include <cstddef>
#include <functional>
#include <mutex>

namespace CGAL::Shape_correspondence::internal {

inline void check(const Energy_matrix_options& options)
{
  if (!(options.unmatched_energy >= 0) || !std::isfinite(options.unmatched_energy))
    throw Invalid_input("energy_matrix: the energy of unmatched parts must be finite and not negative");
}

/// Reports finished work to a callback, one call at a time, and records whether the callback ended the work.
class Shared_progress
{
public:
  Shared_progress(const std::function<bool(std::size_t, std::size_t)>& callback, std::size_t total)
      : callback_(callback), total_(total)
  {}

  bool is_ended() const { return ended_; }

  void add_one()
  {
    if (!callback_) return;
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!ended_ && !callback_(++done_, total_)) ended_ = true;
  }

private:
  const std::function<bool(std::size_t, std::size_t)>& callback_;
  std::size_t total_, done_ = 0;
  std::atomic<bool> ended_{false};
  std::mutex mutex_;
};

} // namespace CGAL::Shape_correspondence::internal

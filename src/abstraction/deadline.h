// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <chrono>
#include <functional>
#include <stdexcept>
#include <utility>

namespace CGAL::Shape_correspondence::internal {

/// A part that the flow cannot treat; the message says why. Thrown inside this room only.
class Flow_failure : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// The time limit of a part was reached.
class Out_of_time : public Flow_failure
{
public:
  using Flow_failure::Flow_failure;
};

class Stop_watch
{
public:
  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

  /// Milliseconds since the last call, or the start.
  double lap()
  {
    const Clock::time_point now = Clock::now();
    const double result = std::chrono::duration<double, std::milli>(now - last_).count();
    last_ = now;
    return result;
  }

private:
  using Clock = std::chrono::steady_clock;

  Clock::time_point start_ = Clock::now();
  Clock::time_point last_ = start_;
};

/// The time that a part may take, where the caller sets one. Without, all steps are bounded by the size of their input.
class Deadline
{
public:
  /// Seconds that have passed.
  using Clock = std::function<double()>;

  explicit Deadline(double seconds) : Deadline(seconds, [watch = Stop_watch()] { return watch.seconds(); }) {}
  Deadline(double seconds, Clock clock) : seconds_(seconds), clock_(std::move(clock)) {}

  void check() const
  {
    if (clock_() >= seconds_) throw Out_of_time("it needs more time than allowed");
  }

private:
  double seconds_;
  Clock clock_;
};

} // namespace CGAL::Shape_correspondence::internal

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <chrono>
#include <functional>
#include <limits>
#include <stdexcept>
#include <utility>

namespace CGAL::Shape_correspondence::internal {

/// Thrown when a time limit is reached. The code that set the limit catches it and uses a cheaper method.
class Out_of_time : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

class Stop_watch
{
public:
  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

  /// Milliseconds since the last call, or since the start.
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

/// The time limit of a computation. By default there is none: the size of the input bounds the number of steps.
class Deadline
{
public:
  /// Function that returns the seconds since the limit was set; tests give one of their own.
  using Clock = std::function<double()>;

  static constexpr double never = std::numeric_limits<double>::infinity();

  explicit Deadline(double seconds = never) : Deadline(seconds, [watch = Stop_watch()] { return watch.seconds(); }) {}
  Deadline(double seconds, Clock clock) : seconds_(seconds), clock_(std::move(clock)) {}

  /// Seconds left; `never` without a limit.
  double left() const { return seconds_ < never ? seconds_ - clock_() : never; }
  bool is_over() const { return left() <= 0; }

  void check() const
  {
    if (is_over()) throw Out_of_time("it needs more time than allowed");
  }

private:
  double seconds_;
  Clock clock_;
};

} // namespace CGAL::Shape_correspondence::internal

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>

namespace shape_correspondence_python {

namespace py = pybind11;

/// Work that runs in a thread of its own, without Python's lock, while the calling thread reports its progress to
/// Python and looks for signals. The two share this.
class Work
{
public:
  /// Thrown to end work that has no other way to stop.
  struct Stopped
  {};

  /// For the working thread: reports progress. \throw Stopped if the calling thread was interrupted
  void report(const std::string& what, std::size_t done, std::size_t total);
  /// For the working thread: reports progress as a share in [0, 1], and waits for the answer. \return whether to go on;
  /// a search that is ended keeps what it has found
  bool report_share(const std::string& what, double share);

  /// Runs `work(*this)`.
  /// \param progress None, or a function of a share in [0, 1] and of what is done; `False` ends a search
  template <typename Function>
  auto run(const py::object& progress, const Function& work)
  {
    std::optional<decltype(work(*this))> result;
    std::exception_ptr failure;
    std::thread thread([&] {
      try {
        result = work(*this);
      } catch (...) {
        failure = std::current_exception();
      }
      finish();
    });
    const std::exception_ptr python_failure = wait(progress);
    {
      py::gil_scoped_release unlocked;
      thread.join();
    }
    if (python_failure) std::rethrow_exception(python_failure);
    if (failure) std::rethrow_exception(failure);
    return std::move(*result);
  }

private:
  struct Report
  {
    double share;
    std::string what;
  };

  void set_report(const std::string& what, double share);
  void answer();
  void finish();
  /// Waits until work has finished. \return what Python raised meanwhile
  std::exception_ptr wait(const py::object& progress);
  /// Waits for a report, for `signal_interval` at most. \return the report, if there is one, and whether work goes on
  std::pair<std::optional<Report>, bool> next_report();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<Report> report_;
  bool answered_ = true, finished_ = false;
  std::atomic<bool> ended_{false}, stopped_{false}; // whether a search, or all work, is to end
};

} // namespace shape_correspondence_python

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "work.h"

#include <chrono>
#include <tuple>

namespace shape_correspondence_python {

namespace {

constexpr std::chrono::milliseconds signal_interval{50}; // time between checks for Ctrl-C

} // namespace

void Work::report(const std::string& what, std::size_t done, std::size_t total)
{
  set_report(what, total == 0 ? 1 : double(done) / double(total));
  if (stopped_) throw Stopped();
}

bool Work::report_share(const std::string& what, double share)
{
  set_report(what, share);
  std::unique_lock<std::mutex> lock(mutex_);
  changed_.wait(lock, [this] { return answered_; });
  return !ended_ && !stopped_;
}

void Work::set_report(const std::string& what, double share)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  report_ = Report{share, what};
  answered_ = false;
  changed_.notify_all();
}

void Work::answer()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  answered_ = !report_; // a further report may have come meanwhile
  changed_.notify_all();
}

void Work::finish()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  finished_ = true;
  changed_.notify_all();
}

std::pair<std::optional<Work::Report>, bool> Work::next_report()
{
  py::gil_scoped_release unlocked;
  std::unique_lock<std::mutex> lock(mutex_);
  changed_.wait_for(lock, signal_interval, [this] { return report_ || finished_; });
  return {std::exchange(report_, std::nullopt), !finished_};
}

std::exception_ptr Work::wait(const py::object& progress)
{
  std::exception_ptr failure;
  for (bool goes_on = true; goes_on;) {
    std::optional<Report> report;
    std::tie(report, goes_on) = next_report();
    try {
      if (!failure && PyErr_CheckSignals() != 0) throw py::error_already_set();
      if (!failure && report && !progress.is_none() && progress(report->share, report->what).is(py::bool_(false)))
        ended_ = true;
    } catch (py::error_already_set&) {
      failure = std::current_exception();
      stopped_ = true;
    }
    if (report) answer();
  }
  return failure;
}

} // namespace shape_correspondence_python

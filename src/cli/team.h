// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::cli {

/// The processes that work on a collection: this one, or those started by `mpirun` (`team_mpi.cpp`). All processes of a
/// team make the same calls in the same order.
class Team
{
public:
  virtual ~Team() = default;

  virtual std::size_t size() const { return 1; }
  virtual bool is_first() const { return true; }
  /// Number of processes on this machine.
  virtual std::size_t size_here() const { return 1; }

  /// Distributes the numbers from 0 to n - 1 in order over the processes as they become free; returns when all are
  /// done. \throw Invalid_input in all processes if `work` throws in one of them
  virtual void for_each(std::size_t n, const std::function<void(std::size_t)>& work)
  {
    for (std::size_t i = 0; i < n; ++i)
      work(i);
  }

  virtual std::vector<std::string> gathered(const std::string& text) { return {text}; }
  /// The numbers passed by the first process.
  virtual std::vector<std::size_t> from_first(std::vector<std::size_t> numbers) { return numbers; }
};

/// Creates the team of this process; `shape_correspondence_mpi` replaces this function.
/// \throw Usage_error
extern std::unique_ptr<Team> (*make_team)();

} // namespace CGAL::Shape_correspondence::cli

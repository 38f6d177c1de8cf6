// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::cli {

/// The processes that work on one collection: this one, or those that `mpirun` started (`team_mpi.cpp`). All processes
/// of a team make the same calls in the same order.
class Team
{
public:
  virtual ~Team() = default;

  virtual std::size_t size() const { return 1; }
  virtual bool is_first() const { return true; }
  /// Processes on this machine, this one included.
  virtual std::size_t size_here() const { return 1; }

  /// Hands out the numbers from 0 to n - 1 to the processes, each once and in their order, as they get free; returns
  /// when all are done. \throw Invalid_input at all processes if `work` throws at one of them
  virtual void for_each(std::size_t n, const std::function<void(std::size_t)>& work)
  {
    for (std::size_t i = 0; i < n; ++i)
      work(i);
  }

  /// The texts of all processes.
  virtual std::vector<std::string> gathered(const std::string& text) { return {text}; }
  /// What the first process has.
  virtual std::vector<std::size_t> from_first(std::vector<std::size_t> numbers) { return numbers; }
};

/// Makes the team of this process; the program `shape_correspondence_mpi` puts its own function here.
/// \throw Usage_error
extern std::unique_ptr<Team> (*make_team)();

} // namespace CGAL::Shape_correspondence::cli

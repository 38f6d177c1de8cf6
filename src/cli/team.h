// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::cli {

/// The processes that work on one collection: this one, or those that `mpirun` started, where the program was built
/// with MPI. All processes of a team make the same calls in the same order.
class Team
{
public:
  Team();
  ~Team();

  std::size_t size() const;
  bool is_first() const;
  /// Processes on this machine, this one included.
  std::size_t size_here() const;

  /// Hands out the numbers from 0 to n - 1 to the processes, each once and in their order, as they get free; returns
  /// when all are done. \throw Invalid_input at all processes if `work` throws at one of them
  void for_each(std::size_t n, const std::function<void(std::size_t)>& work);

  /// The texts of all processes.
  std::vector<std::string> gathered(const std::string& text);
  /// What the first process has.
  std::vector<std::size_t> from_first(std::vector<std::size_t> numbers);

private:
  struct Impl;

  std::unique_ptr<Impl> impl_; // null: this process alone
};

} // namespace CGAL::Shape_correspondence::cli

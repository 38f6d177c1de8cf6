// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_SRC_CLI_TEAM_H
#define CGAL_SHAPE_CORRESPONDENCE_SRC_CLI_TEAM_H

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {
namespace cli {

/// The processes that work on one collection: this one, or those that `mpirun` started, where the program was built
/// with MPI.
class Team
{
public:
  std::size_t size() const { return 1; }
  bool is_first() const { return true; }

  /// Hands out the numbers from 0 to n - 1 to the processes, each once, one after the other as they get free. All
  /// processes call it, and leave it when all numbers are done.
  void for_each(std::size_t n, const std::function<void(std::size_t)>& work)
  {
    for (std::size_t i = 0; i < n; ++i)
      work(i);
  }

  /// The texts of all processes, at all of them.
  std::vector<std::string> gathered(const std::string& text) { return {text}; }
};

} // namespace cli
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_SRC_CLI_TEAM_H

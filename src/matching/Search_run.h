// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "energy/Matching_problem.h"

#include <CGAL/Shape_correspondence/Search_result.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

// One run of a search; the source of its problem is the shape that is deformed.
struct Search_run
{
  Matching_problem problem;
  Direction direction;
  int turns;                    // of the target
  std::size_t coarse_parts = 0; // that were matched first; 0: all at once
  Search_result result;

  using Shared_shape = Matching_problem::Shared_shape;

  // \throw Out_of_time, Too_large if there is not the time or the memory for its tables
  Search_run(const Shared_shape& source, const Shared_shape& target, Direction direction, int turns,
             const Search_options& options, const Deadline& deadline);

  // The energy of a known mapping, the only label of every group of the source. Unmatched groups cost nothing.
  Search_run(const Shared_shape& source, const Shared_shape& target, int turns,
             std::vector<std::vector<Group_label>> labels, const Search_options& options, const Deadline& deadline);

  // What runs are compared by: the energy, or the energy per pair of connected parts
  double score(bool by_energy) const;
};

// The options of an exact search until the deadline. \pre the deadline is not over
Exact_options until(const Deadline& deadline, Exact_options options);

// The distinct target parts of a label, ascending.
std::vector<std::size_t> image_parts(const Group_label& label);

// Fills in the parts without a pair.
void collect_unmatched(std::size_t source_parts, std::size_t target_parts, Correspondence& correspondence);

// The correspondence of a solution, without its unmatched parts. \param min_marginals by group, or empty
Correspondence correspondence_of(const Search_run& run, const Solution& solution,
                                 const std::vector<double>& min_marginals);

} // namespace CGAL::Shape_correspondence::internal

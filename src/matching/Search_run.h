// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "energy/Matching_problem.h"

#include <CGAL/Shape_correspondence/Search_result.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

// One run of a search. The source of its problem is the shape that is deformed.
struct Search_run
{
  Matching_problem problem;
  Direction direction;
  int turns;                    // quarter turns of the target
  std::size_t coarse_parts = 0; // number of parts matched first, coarse to fine; 0: all at once
  Search_result result;

  using Shared_shape = Matching_problem::Shared_shape;

  // \throw Out_of_time, Too_large if time or memory does not suffice for the tables
  Search_run(const Shared_shape& source, const Shared_shape& target, Direction direction, int turns,
             const Search_options& options, const Deadline& deadline);

  // Computes the energy of a mapping, given as the only label of each source group. Unmatched groups cost nothing.
  Search_run(const Shared_shape& source, const Shared_shape& target, int turns,
             std::vector<std::vector<Group_label>> labels, const Search_options& options, const Deadline& deadline);

  // The score by which runs are compared: the energy, or the energy per pair of connected parts.
  double score(bool by_energy) const;
};

// The options for an exact search that ends at the deadline. \pre the deadline is not over
Exact_options until(const Deadline& deadline, Exact_options options);

std::vector<std::size_t> image_parts(const Group_label& label);

// Lists the parts without a pair.
void collect_unmatched(std::size_t source_parts, std::size_t target_parts, Correspondence& correspondence);

// The correspondence of a solution, without its unmatched parts. \param min_marginals by group; may be empty
Correspondence correspondence_of(const Search_run& run, const Solution& solution,
                                 const std::vector<double>& min_marginals);

} // namespace CGAL::Shape_correspondence::internal

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SHAPE_CORRESPONDENCE_TEST_BRUTE_FORCE_H
#define SHAPE_CORRESPONDENCE_TEST_BRUTE_FORCE_H

#include <CGAL/Shape_correspondence/Matching_problem.h>

#include <algorithm>

// The least energy of all assignments, one by one.
inline double brute_force(const CGAL::Shape_correspondence::Matching_problem& problem)
{
  CGAL::Shape_correspondence::Assignment assignment(problem.source().groups.size(), 0);
  double best = problem.energy(assignment);
  for (std::size_t g = 0; g < assignment.size();) {
    if (++assignment[g] == int(problem.number_of_labels())) {
      assignment[g++] = 0;
      continue;
    }
    best = std::min(best, problem.energy(assignment));
    g = 0;
  }
  return best;
}

#endif // SHAPE_CORRESPONDENCE_TEST_BRUTE_FORCE_H

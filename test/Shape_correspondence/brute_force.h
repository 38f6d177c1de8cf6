// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SHAPE_CORRESPONDENCE_TEST_BRUTE_FORCE_H
#define SHAPE_CORRESPONDENCE_TEST_BRUTE_FORCE_H

#include <CGAL/Shape_correspondence/Pairwise_energy.h>

#include <algorithm>
#include <vector>

// The energies of all assignments that satisfy `is_allowed`, ascending.
template <typename Predicate>
std::vector<double> brute_force(const CGAL::Shape_correspondence::Pairwise_energy& energy, const Predicate& is_allowed)
{
  CGAL::Shape_correspondence::Assignment assignment(energy.number_of_variables(), 0);
  std::vector<double> energies;
  for (std::size_t v = 0; v < assignment.size();) {
    if (is_allowed(assignment)) energies.push_back(energy(assignment));
    for (v = 0; v < assignment.size() && ++assignment[v] == int(energy.number_of_labels(v)); ++v)
      assignment[v] = 0;
  }
  std::sort(energies.begin(), energies.end());
  return energies;
}

inline std::vector<double> brute_force(const CGAL::Shape_correspondence::Pairwise_energy& energy)
{
  return brute_force(energy, [](const CGAL::Shape_correspondence::Assignment&) { return true; });
}

#endif // SHAPE_CORRESPONDENCE_TEST_BRUTE_FORCE_H

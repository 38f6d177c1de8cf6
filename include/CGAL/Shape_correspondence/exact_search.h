// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_EXACT_SEARCH_H
#define CGAL_SHAPE_CORRESPONDENCE_EXACT_SEARCH_H

#include <CGAL/Shape_correspondence/Matching_problem.h>

#include <cstddef>

namespace CGAL {
namespace Shape_correspondence {

/// Options of `exact_search()`.
struct Exact_options
{
  std::size_t table_limit = 1u << 20; ///< entries of one table of the bound; wider groups of terms are split
  std::size_t node_limit = 2'000'000; ///< nodes of the search tree, after which the best solution so far is returned
};

/// Finds the assignment of least energy and proves it. The energy is a sum of terms of one and two groups but for the
/// square root in E_s, which its tangents bound from below. Bucket elimination along a min-fill order solves the
/// additive part (exactly where its tables fit, else by mini-buckets, a lower bound; Dechter and Rish 2003) and guides
/// a depth-first branch and bound over what the bound leaves, so that the result is optimal for the energy itself.
/// Where the node limit ends the search, `optimal` is false and `summary.lower_bound` tells the gap. Deterministic.
Search_result exact_search(const Matching_problem& problem, const Exact_options& options = {});

} // namespace Shape_correspondence
} // namespace CGAL

#ifndef CGAL_SHAPE_CORRESPONDENCE_COMPILED
#include <CGAL/Shape_correspondence/internal/exact_search_impl.h>
#endif

#endif // CGAL_SHAPE_CORRESPONDENCE_EXACT_SEARCH_H

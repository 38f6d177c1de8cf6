// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_EXACT_SEARCH_H
#define CGAL_SHAPE_CORRESPONDENCE_EXACT_SEARCH_H

#include <CGAL/Shape_correspondence/Exact_options.h>
#include <CGAL/Shape_correspondence/Search_result.h>

#include <memory>
#include <vector>

namespace CGAL::Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceSearch
/// Finds the assignments of least energy and proves that no others have less. Root terms are bounded from below by
/// their tangents, which leaves a sum of terms of one and of two variables. Bucket elimination along a min-fill order
/// minimizes it exactly if its tables fit into `Exact_options::table_limit`; otherwise message passing (TRW-S;
/// Kolmogorov 2006) redistributes costs so that mini-buckets (Dechter and Rish 2003) bound it well. Depth-first branch
/// and bound with this bound makes the result optimal for the energy itself; if slow, it restarts with larger tables.
/// Deterministic without a time limit.
///
/// Time: O(number of variables · labels^(w + 1)) for tables of induced width w that fit, exponential in the worst case.
/// If a limit ends the search, `optimal` is false and `summary.lower_bound` is the proven lower bound.
class Exact_search
{
public:
  /// Sets up the bound. The energy is kept by reference, so it must not be a temporary.
  explicit Exact_search(const Pairwise_energy& energy, const Exact_options& options = {});
  explicit Exact_search(const Pairwise_energy&& energy, const Exact_options& options = {}) = delete;
  ~Exact_search();

  /// The assignment of least energy, and the next best ones.
  /// \throw Invalid_input if `Exact_options::solutions` is 0
  Search_result run();

  /// The min-marginals, by variable: the increase of the least energy if its label in `result` is forbidden; infinite
  /// for a variable with one label. If a limit ends a search, the increase to the best solution found.
  std::vector<double> min_marginals(const Search_result& result);

private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

/// \ingroup PkgShapeCorrespondenceSearch
/// `Exact_search(energy, options).run()`.
Search_result exact_search(const Pairwise_energy& energy, const Exact_options& options = {});

} // namespace CGAL::Shape_correspondence

#endif // CGAL_SHAPE_CORRESPONDENCE_EXACT_SEARCH_H

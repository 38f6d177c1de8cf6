// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_SEARCH_RESULT_H
#define CGAL_SHAPE_CORRESPONDENCE_SEARCH_RESULT_H

#include <CGAL/Shape_correspondence/Pairwise_energy.h>
#include <CGAL/Shape_correspondence/Search_summary.h>

#include <vector>

namespace CGAL::Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceSearch
/// A complete assignment and its energy.
struct Solution
{
  double energy = 0;     ///< the energy of the assignment
  Assignment assignment; ///< a label for every variable
};

/// \ingroup PkgShapeCorrespondenceSearch
/// The result of a search.
struct Search_result
{
  std::vector<Solution> solutions; ///< the best first; at least one
  bool optimal = false;            ///< whether it is proven that no other assignment has a lower energy than these
  bool out_of_time = false;        ///< whether a time limit ended the search
  Search_summary summary;          ///< effort and lower bound of the search

  /// The first solution.
  const Solution& best() const { return solutions.front(); }
};

} // namespace CGAL::Shape_correspondence

#endif // CGAL_SHAPE_CORRESPONDENCE_SEARCH_RESULT_H

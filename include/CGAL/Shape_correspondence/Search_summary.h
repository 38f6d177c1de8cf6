// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_SEARCH_SUMMARY_H
#define CGAL_SHAPE_CORRESPONDENCE_SEARCH_SUMMARY_H

#include <cstddef>
#include <string>

namespace CGAL::Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceSearch
/// Effort and lower bound of a search.
struct Search_summary
{
  std::string method = "beam"; ///< `parts`, `beam` or `exact`
  std::size_t states = 0;      ///< number of search states kept
  std::size_t evaluations = 0; ///< number of states whose energy, or a lower bound of it, was computed
  double lower_bound = 0;      ///< lower bound of the energy of any correspondence in the direction of the result
};

} // namespace CGAL::Shape_correspondence

#endif // CGAL_SHAPE_CORRESPONDENCE_SEARCH_SUMMARY_H

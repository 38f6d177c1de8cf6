// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_EXACT_OPTIONS_H
#define CGAL_SHAPE_CORRESPONDENCE_EXACT_OPTIONS_H

#include <cstddef>

namespace CGAL::Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceOptions
/// Options of `exact_search()`.
struct Exact_options
{
  /// Initial limit for the number of entries of a table of the bound; larger tables are split. A long search restarts
  /// with larger tables, up to a million entries.
  std::size_t table_limit = 1u << 12;
  std::size_t node_limit =
      2'000'000; ///< limit for the nodes of the search tree; if reached, the best solution so far is returned
  /// Time limit, in seconds from construction; if reached, the best solution so far is returned. 0: no limit, so that
  /// results do not depend on speed.
  double time_limit = 0;
  std::size_t solutions = 1; ///< number of best assignments to return, at least 1
};

} // namespace CGAL::Shape_correspondence

#endif // CGAL_SHAPE_CORRESPONDENCE_EXACT_OPTIONS_H

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_BEAM_OPTIONS_H
#define CGAL_SHAPE_CORRESPONDENCE_BEAM_OPTIONS_H

namespace CGAL::Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceOptions
/// Options of `Search_method::BEAM`, with the paper's values.
struct Beam_options
{
  int beam_width = 20; ///< K, number of partial solutions kept at each level, at least 1
  int expansions = 4;  ///< k, number of expansions kept of each partial solution, at least 1
};

} // namespace CGAL::Shape_correspondence

#endif // CGAL_SHAPE_CORRESPONDENCE_BEAM_OPTIONS_H

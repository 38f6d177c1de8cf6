// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_PAPER_STRUCTURE_OPTIONS_H
#define CGAL_SHAPE_CORRESPONDENCE_PAPER_STRUCTURE_OPTIONS_H

#include <CGAL/Shape_correspondence/build_structural_graph.h>

namespace CGAL::Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceFunctions
/// Options for structural graphs as in the paper: parts are abstracted by mean curvature flow (section 3,
/// "Abstraction"), and contacts are closest pairs of points. Use `paper_options()` to match these graphs.
inline Structure_options paper_structure_options()
{
  Structure_options options;
  options.abstraction.abstractor = Mean_curvature_abstraction();
  options.contacts.closest_points = true;
  return options;
}

} // namespace CGAL::Shape_correspondence

#endif // CGAL_SHAPE_CORRESPONDENCE_PAPER_STRUCTURE_OPTIONS_H

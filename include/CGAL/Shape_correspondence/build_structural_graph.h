// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_BUILD_STRUCTURAL_GRAPH_H
#define CGAL_SHAPE_CORRESPONDENCE_BUILD_STRUCTURAL_GRAPH_H

#include <CGAL/Shape_correspondence/abstract_part.h>
#include <CGAL/Shape_correspondence/detect_contacts.h>
#include <CGAL/Shape_correspondence/detect_symmetry_groups.h>

namespace CGAL::Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceOptions
/// Options of the three steps of `build_structural_graph()`.
struct Structure_options
{
  Abstraction_options abstraction; ///< options of `abstract_parts()`
  Symmetry_options symmetry;       ///< options of `detect_symmetry_groups()`
  Contact_options contacts;        ///< options of `detect_contacts()`
};

/// \ingroup PkgShapeCorrespondenceFunctions
/// Time of the steps of `build_structural_graph()`, in seconds.
struct Structure_times
{
  double abstraction = 0; ///< seconds for abstracting all parts
  double structure = 0;   ///< seconds for finding symmetry groups and contacts
};

/// \ingroup PkgShapeCorrespondenceFunctions
/// Builds the structural graph of a shape: its frame, the abstraction of every part, symmetry groups and contacts.
/// \tparam ConcurrencyTag `CGAL::Sequential_tag` or `CGAL::Parallel_tag`; the result is bitwise identical
/// \param shape the shape
/// \param options the options of the steps
/// \param times receives the time of the steps; may be null
/// \throw Invalid_input if the shape has fewer than 2 or more than 2000 parts, or more than 50000 pairs of them touch
template <typename ConcurrencyTag = CGAL::Sequential_tag>
Structural_graph build_structural_graph(const Segmented_shape& shape, const Structure_options& options = {},
                                        Structure_times* times = nullptr);

/// \ingroup PkgShapeCorrespondenceFunctions
/// Builds the graph of a shape with given abstractions of its parts: detects the groups if `groups` is empty, and the
/// contacts if `shape.contacts` is empty. Uses the given frame.
/// \throw Invalid_input if the shape has fewer than two parts or more than 2000, if more than 50000 pairs of them
/// touch, if a coordinate is not finite or beyond 1e15, or if a volume or area is negative or beyond 1e50
Structural_graph complete_structural_graph(Shape_structure shape, std::vector<Part_group> groups,
                                           const Structure_options& options = {});

} // namespace CGAL::Shape_correspondence

#endif // CGAL_SHAPE_CORRESPONDENCE_BUILD_STRUCTURAL_GRAPH_H

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_MATCH_AS_IN_PAPER_H
#define CGAL_SHAPE_CORRESPONDENCE_MATCH_AS_IN_PAPER_H

#include <CGAL/Shape_correspondence/build_structural_graph.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

namespace CGAL {
namespace Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceFunctions
/// Structural graphs as in the paper: parts are abstracted by mean curvature flow (section 3, "Abstraction"), and two
/// parts touch at a closest pair of points.
inline Structure_options paper_structure_options()
{
  Structure_options options;
  options.abstraction.abstractor = Mean_curvature_abstraction();
  options.contacts.closest_points = true;
  return options;
}

/// \ingroup PkgShapeCorrespondenceFunctions
/// Two structural graphs and their correspondence.
struct Paper_match
{
  Structural_graph source;       ///< of the source shape
  Structural_graph target;       ///< of the target shape
  Correspondence correspondence; ///< of their parts
};

/// \ingroup PkgShapeCorrespondenceFunctions
/// The paper's method from surfaces to correspondence: `build_structural_graph()` with `paper_structure_options()`,
/// then `find_correspondence()` with `paper_options()`.
/// \tparam ConcurrencyTag `CGAL::Sequential_tag` or `CGAL::Parallel_tag`; the result is bitwise identical
/// \param source,target the shapes
/// \throw Invalid_input if a shape has fewer than two parts, or more than 150 symmetry groups
template <typename ConcurrencyTag = CGAL::Sequential_tag>
Paper_match match_as_in_paper(const Segmented_shape& source, const Segmented_shape& target)
{
  const Structure_options options = paper_structure_options();
  Paper_match result{build_structural_graph<ConcurrencyTag>(source, options),
                     build_structural_graph<ConcurrencyTag>(target, options),
                     {}};
  result.correspondence = find_correspondence(result.source, result.target, paper_options());
  return result;
}

} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_MATCH_AS_IN_PAPER_H

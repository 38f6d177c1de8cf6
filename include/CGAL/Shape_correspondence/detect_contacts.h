// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_DETECT_CONTACTS_H
#define CGAL_SHAPE_CORRESPONDENCE_DETECT_CONTACTS_H

#include <CGAL/Shape_correspondence/Segmented_shape.h>
#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <CGAL/tags.h>

#include <string>
#include <vector>

namespace CGAL::Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceOptions
/// Options of `detect_contacts()`.
struct Contact_options
{
  double tolerance = 0.02; ///< largest gap between parts in contact, as a fraction of the diagonal of the shape
  /// Whether contacts are at a closest pair of points (paper, section 3) rather than in the middle of the region where
  /// the parts are nearly as close.
  bool closest_points = false;
};

/// \ingroup PkgShapeCorrespondenceGraph
/// Finds the pairs of parts whose surfaces touch, interpenetrate or nearly touch, and where (paper, section 3: "a point
/// from each part with minimum distance"; of all such points, the middle). A part inside another touches it. Each pair
/// of parts has one contact, with a region for every place where their distance exceeds the least one by at most half
/// the tolerance. The connected components of a disconnected shape are joined by their closest pairs; every such pair
/// adds a sentence to `warnings`. Contacts are sorted by part indices. Distances of surfaces are exact up to rounding.
/// \tparam ConcurrencyTag `CGAL::Sequential_tag` or `CGAL::Parallel_tag`; the result is bitwise identical
/// \param shape the shape
/// \param parts the abstractions of its parts, for the parameters of contacts
/// \param frame frame of the shape, in which distances are measured, independently of the shape's pose
/// \param options the options
/// \param warnings receives sentences on approximations
/// \throw Invalid_input if more than 50000 pairs of parts touch
/// \pre `parts` are the abstractions of `shape.parts()`
template <typename ConcurrencyTag = CGAL::Sequential_tag>
std::vector<Contact> detect_contacts(const Segmented_shape& shape, const std::vector<Part_abstraction>& parts,
                                     const Shape_frame& frame, const Contact_options& options,
                                     std::vector<std::string>& warnings);

/// \ingroup PkgShapeCorrespondenceGraph
/// The same for parts without meshes, whose surfaces are estimated from their abstractions and volumes.
std::vector<Contact> detect_contacts(const std::vector<Part_abstraction>& parts, const Shape_frame& frame,
                                     const Contact_options& options, std::vector<std::string>& warnings);

} // namespace CGAL::Shape_correspondence

#endif // CGAL_SHAPE_CORRESPONDENCE_DETECT_CONTACTS_H

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_PART_MAP_H
#define CGAL_SHAPE_CORRESPONDENCE_PART_MAP_H

#include <CGAL/Shape_correspondence/Part_correspondence.h>

#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence {

struct Correspondence;

/// \ingroup PkgShapeCorrespondenceSets
/// Corresponding parts with their confidences: the part of a `Correspondence` that is stored for sets of shapes.
struct Part_map
{
  /// Pairs of whole parts, sorted by source, then target, each once; the confidence is 1 if the method computes none.
  std::vector<Part_correspondence> pairs;

  /// Whether all pairs and confidences are equal.
  friend bool operator==(const Part_map& a, const Part_map& b) { return a.pairs == b.pairs; }
};

/// \ingroup PkgShapeCorrespondenceSets
/// The part map of two shapes of a set.
struct Shape_pair_map
{
  std::size_t source; ///< index of the source shape
  std::size_t target; ///< index of the target shape
  Part_map map;       ///< map from the source to the target
};

/// \ingroup PkgShapeCorrespondenceSets
/// The part map of a correspondence.
Part_map part_map(const Correspondence& correspondence);

/// \ingroup PkgShapeCorrespondenceSets
/// The map of every part to itself, with confidence 1.
Part_map identity_part_map(std::size_t parts);

/// \ingroup PkgShapeCorrespondenceSets
/// The map with source and target swapped.
Part_map inverse(const Part_map& map);

/// \ingroup PkgShapeCorrespondenceSets
/// The composition of `first`, then `second`: two parts correspond if both correspond to a common intermediate part;
/// maps may be one-to-many. The confidence is the largest product of the two confidences over all intermediate parts.
Part_map composed(const Part_map& first, const Part_map& second);

} // namespace CGAL::Shape_correspondence

#endif // CGAL_SHAPE_CORRESPONDENCE_PART_MAP_H

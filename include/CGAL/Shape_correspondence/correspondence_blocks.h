// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_CORRESPONDENCE_BLOCKS_H
#define CGAL_SHAPE_CORRESPONDENCE_CORRESPONDENCE_BLOCKS_H

#include <CGAL/Shape_correspondence/Correspondence.h>
#include <CGAL/Shape_correspondence/Geotopo_operation.h>

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceCorrespondence
/// A set of source parts and a set of target parts that correspond as wholes.
struct Correspondence_block
{
  std::vector<std::size_t> source;        ///< part indices in the source shape, ascending, not empty
  std::vector<std::size_t> target;        ///< part indices in the target shape, ascending, not empty
  std::string role;                       ///< most frequent role of its parts; empty if roles are unknown
  Operation operation = Operation::MATCH; ///< how the source parts become the target parts
  /// Mean confidence of its pairs, in [0, 1]; NaN if the method does not compute confidences.
  double confidence = std::numeric_limits<double>::quiet_NaN();
};

/// \ingroup PkgShapeCorrespondenceCorrespondence
/// Partitions the parts with a counterpart into blocks, sorted by their first source part. Blocks are built by
/// agglomerative clustering: the two sets of parts whose pairs have the greatest mean confidence are joined, where
/// pairs of different roles count half, and pairs that are not in `correspondence` count 0. Two sets that both have
/// parts of source and target stay apart if that mean is less than half of the mean inside either, so that a few
/// uncertain pairs do not connect sets that correspond well on their own. Pairs without confidences count 1; without
/// confidences and roles, blocks are the connected components of the pairs.
///
/// The result does not depend on the order of parts, or on which shape is the source.
/// Complexity: for <i>p</i> pairs and <i>n</i> parts, O((<i>p</i> + <i>n</i>²) log <i>n</i>).
std::vector<Correspondence_block> correspondence_blocks(const Correspondence& correspondence);

} // namespace CGAL::Shape_correspondence

#endif // CGAL_SHAPE_CORRESPONDENCE_CORRESPONDENCE_BLOCKS_H

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_MATCH_PARTS_H
#define CGAL_SHAPE_CORRESPONDENCE_MATCH_PARTS_H

#include <CGAL/Shape_correspondence/Part_costs.h>
#include <CGAL/Shape_correspondence/config.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {

/// Options of `match_parts()`; all are costs of `part_costs()`.
struct Part_matching_options
{
  Part_cost_weights weights;
  /// A pair is matched if it costs least for one of its parts and, over both parts, at most so much more than least.
  /// Less of it: fewer and surer pairs.
  double excess = 2;
  double sure_excess = 0.5; ///< the same, for pairs that decide which sets of parts stand for one another
  double sibling = 4;       ///< parts of one shape that cost less among each other may share a counterpart
};

/// Two parts that correspond, by index of the aligned shapes.
struct Part_match
{
  std::size_t source, target;
  double confidence; ///< how probable it is, between 0 and 1
};

/// A part-to-part correspondence. What has no counterpart is in no pair.
struct Part_matching
{
  std::vector<Part_match> pairs; ///< by source, then target
  Eigen::MatrixXd costs;         ///< source part × target part, by index of the aligned shapes
};

/// Matches parts by their costs alone, without deforming a shape.
///
/// A pair is judged by how much more it costs than the best one of either part, so that no cost is too high for parts
/// that have nothing better. Sure pairs join parts and groups of both shapes to blocks. A part that is in no sure pair
/// joins the block of the parts it resembles most. A block with as many parts on either side keeps its pairs (four legs
/// and four legs); of one with different numbers, every part corresponds to every other (a back of five slats and one
/// of seven; a pedestal and four legs).
///
/// Deterministic; the source and the target have the same standing. O(n m k²) as `part_costs()`, and O(b³) for b
/// blocks. \throw Invalid_input if a weight or an option is negative or not finite
Part_matching match_parts(const Aligned_shape& source, const Aligned_shape& target,
                          const Part_matching_options& options = {});

} // namespace Shape_correspondence
} // namespace CGAL

#ifndef CGAL_SHAPE_CORRESPONDENCE_COMPILED
#include <CGAL/Shape_correspondence/internal/match_parts_impl.h>
#endif

#endif // CGAL_SHAPE_CORRESPONDENCE_MATCH_PARTS_H

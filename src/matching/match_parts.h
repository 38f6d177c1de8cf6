// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "energy/Match_constraints.h"
#include "matching/Part_costs.h"

#include <CGAL/Shape_correspondence/Part_correspondence.h>

#include <Eigen/Core>

#include <vector>

namespace CGAL::Shape_correspondence {

/// A part-to-part correspondence of two aligned shapes.
struct Part_matching
{
  std::vector<Part_correspondence> pairs; ///< by source, then target, by index of the aligned shapes
  Eigen::MatrixXd costs;                  ///< source part × target part, by index of the aligned shapes
  bool upside_down = false;               ///< one shape was turned over, as a lamp that hangs from a chain
  Eigen::MatrixXd probabilities;          ///< source part × target part; empty without roles
};

/// Matches parts by their costs alone, without deforming a shape.
///
/// A pair is judged by how much more it costs than the best one of either part, so that no cost is too high for parts
/// that have nothing better. Pairs that cost little more than the best ones, the confident ones, join parts and panels
/// of both shapes to blocks. A block with as many parts of either shape keeps its pairs (four legs and four legs); of
/// one with different numbers every part corresponds to every other (a back of five slats and one of seven; a pedestal
/// and four legs), as in a block with a panel, whose parts have no places of their own, unless they pair one to one at
/// no more than `Part_matching_options::tolerance`: those are the same parts.
///
/// The supports of the shapes (`Part_assemblies::support`) are matched as sets, and with nothing else, unless their
/// parts pair one to one, but for some that stand on the ground apart from the others (a ladder beside the legs of a
/// bed). Where one of the two shapes has a chain, it hangs, and is turned over. Pinned pairs are in the result, with
/// confidence 1; pairs that are not allowed are not.
///
/// Deterministic; the source and the target have the same standing. O(n m k²) as `part_costs()`. \throw Invalid_input
/// if a weight or an option is negative or not finite
Part_matching match_parts(const Aligned_shape& source, const Aligned_shape& target,
                          const Part_matching_options& options = {},
                          const internal::Match_constraints& constraints = {});

/// The same of shapes with known features, made by the same options. \param deadline as of `part_costs()`
Part_matching match_parts(const internal::Shape_features& source, const internal::Shape_features& target,
                          const Part_matching_options& options, const internal::Match_constraints& constraints,
                          const internal::Deadline* deadline = &internal::no_deadline);

/// Removes the pairs that are not allowed and adds those that are pinned.
void constrain(const internal::Match_constraints& constraints, Part_matching& matching);

} // namespace CGAL::Shape_correspondence

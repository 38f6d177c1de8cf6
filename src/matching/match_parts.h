// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "energy/match_groups.h"
#include "matching/Part_costs.h"

#include <CGAL/Shape_correspondence/Part_correspondence.h>

#include <Eigen/Core>

#include <vector>

namespace CGAL::Shape_correspondence {

/// Limit of `Part_cost_weights::features`, which keeps costs of features below those of forbidden pairs.
constexpr double largest_feature_weight = 1000;

/// A part-to-part correspondence of two aligned shapes.
struct Part_matching
{
  std::vector<Part_correspondence> pairs; ///< sorted by source, then target; indices of parts of the aligned shapes
  Eigen::MatrixXd costs;         ///< `part_costs()`: source part × target part, by index of the aligned shapes
  bool upside_down = false;      ///< whether one shape was turned over, such as a lamp that hangs from a chain
  Eigen::MatrixXd probabilities; ///< of every pair: source part × target part; empty without roles
  Eigen::MatrixXd evidence;      ///< `evidence_of_features()`
};

/// Matches parts by their costs alone, without deforming a shape.
///
/// A pair is judged by how much its cost exceeds the least costs of its parts, so that no cost is too high for parts
/// without a better counterpart. Pairs of small excess, the confident ones, join parts and panels of both shapes to
/// blocks. A block with equally many parts of both shapes keeps its pairs (four legs and four legs). In a block with
/// different numbers, every part corresponds to every other (five and seven slats; a pedestal and four legs); so it
/// does in a block with a panel, unless the parts pair one to one at costs up to `Part_matching_options::tolerance`.
///
/// The supports of the shapes (`Part_assemblies::support`) are matched as sets, and only with each other, unless their
/// parts pair one to one, apart from legs left over on the ground (a ladder beside the legs of a bed). If one of the
/// two shapes has a chain, it hangs, and is turned over. Pinned pairs get confidence 1; pairs that are not allowed are
/// left out.
///
/// Deterministic, and symmetric in source and target. O(n m k²), see `part_costs()`.
/// \throw Invalid_input if a weight or an option is negative or not finite
Part_matching match_parts(const Aligned_shape& source, const Aligned_shape& target,
                          const Part_matching_options& options = {},
                          const internal::Match_constraints& constraints = {});

/// Matches shapes whose features were computed with the same options. \param deadline see `part_costs()`
Part_matching match_parts(const internal::Shape_features& source, const internal::Shape_features& target,
                          const Part_matching_options& options, const internal::Match_constraints& constraints,
                          const internal::Deadline* deadline = &internal::no_deadline);

/// Removes the pairs that are not allowed and adds the pinned ones.
void constrain(const internal::Match_constraints& constraints, Part_matching& matching);

} // namespace CGAL::Shape_correspondence

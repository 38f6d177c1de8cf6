// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "base/quantized.h"
#include "energy/match_groups.h"
#include "matching/match_parts.h"
#include "roles/pair_model.h"

#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

// Operations on a part matching of two aligned shapes.

// The label of every group of the source by the matching. S_i is known where a group becomes all of another group.
// Clones are whole parts, since the lower bound of an energy is over those.
std::vector<std::vector<Group_label>> group_labels(const Part_matching& matching, const Aligned_shape& source,
                                                   const Aligned_shape& target);

// Dissimilarity of the shapes in the alignment, quantized: costs of parts, which are compared in unit boxes, and the
// difference of the shapes' proportions.
Steps alignment_cost(const Part_matching& matching, const Aligned_shape& source, const Aligned_shape& target);

// The pairs, by index in the structural graphs.
std::vector<Part_correspondence> original_pairs(const Part_matching& matching, const Aligned_shape& source,
                                                const Aligned_shape& target);

// The most probable source part of a target part. Without roles: the matched one of most confidence, or else, with
// confidence 0, the one of least cost.
Part_correspondence likeliest_source(const Part_matching& matching, std::size_t target);

// A matching by other indices of the parts. \param rows, columns the new indices of the source and the target parts
Part_matching renumbered(const Part_matching& matching, const std::vector<std::size_t>& rows,
                         const std::vector<std::size_t>& columns);

// The geometric match with the pairs of greatest expected F1 in place of its own, by source, then target, and with the
// probabilities of all pairs, which are the confidences. Parts that the geometric match takes for the same part, at
// no more than `Part_matching_options::tolerance`, correspond to each other only: however many parts have the same
// label, a shape corresponds to itself part by part. Pinned pairs are certain, others of their parts impossible.
Part_matching match_by_terms(const Pair_terms& terms, const Pair_weights& weights, Part_matching geometric,
                             const Match_constraints& constraints = {}, const Part_matching_options& options = {});

// Replaces the probabilities of pairs by the confidences that they are right.
void state_confidences(const Confidence_weights& weights, Part_matching& matching);

} // namespace CGAL::Shape_correspondence::internal

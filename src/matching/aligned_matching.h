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

// The label of every source group: what its parts correspond to in the matching. S_i is set if the group corresponds to
// a whole target group, else it is 1. Images are whole parts, as in the lower bound of the energy.
std::vector<std::vector<Group_label>> group_labels(const Part_matching& matching, const Aligned_shape& source,
                                                   const Aligned_shape& target);

// Quantized dissimilarity of the shapes in the alignment: the costs of parts, which are compared in unit boxes, plus
// the difference of the shapes' proportions.
Steps alignment_cost(const Part_matching& matching, const Aligned_shape& source, const Aligned_shape& target);

// The pairs of a matching, by the indices of parts in the structural graphs.
std::vector<Part_correspondence> original_pairs(const Part_matching& matching, const Aligned_shape& source,
                                                const Aligned_shape& target);

// The most probable source part of a target part. Without roles: its pair of most confidence, or if it has none, the
// part of least cost with confidence 0.
Part_correspondence likeliest_source(const Part_matching& matching, std::size_t target);

// The matching with renumbered parts. \param rows, columns the new indices of the source and the target parts
Part_matching renumbered(const Part_matching& matching, const std::vector<std::size_t>& rows,
                         const std::vector<std::size_t>& columns);

// The geometric match, with its pairs replaced by those of greatest expected F1, ordered by source, then target, and
// with the probabilities of all pairs as confidences. Parts that the geometric match pairs as the same part, at a cost
// of at most `Part_matching_options::tolerance`, correspond only to each other, so that a shape corresponds to itself
// part by part even if many parts have the same label. Pinned pairs get probability 1, other pairs of their parts 0.
Part_matching match_by_terms(const Pair_terms& terms, const Pair_weights& weights, Part_matching geometric,
                             const Match_constraints& constraints = {}, const Part_matching_options& options = {});

// Replaces the probabilities of pairs by calibrated confidences.
void state_confidences(const Confidence_weights& weights, Part_matching& matching);

} // namespace CGAL::Shape_correspondence::internal

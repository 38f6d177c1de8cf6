// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "matching/match_parts.h"
#include "roles/pair_model.h"

namespace CGAL::Shape_correspondence::internal {

// The geometric match with the pairs of greatest expected F1 in place of its own, by source, then target, and with the
// probabilities of all pairs, which are the confidences. Parts that the geometric match takes for the same part, at
// no more than `Part_matching_options::tolerance`, correspond to each other only: however many parts have the same
// label, a shape corresponds to itself part by part. Pinned pairs are certain, others of their parts impossible.
Part_matching match_by_terms(const Pair_terms& terms, const Pair_weights& weights, Part_matching geometric,
                             const Match_constraints& constraints = {}, const Part_matching_options& options = {});

// Replaces the probabilities of pairs by the confidences that they are right.
void state_confidences(const Confidence_weights& weights, Part_matching& matching);

} // namespace CGAL::Shape_correspondence::internal

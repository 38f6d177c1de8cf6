// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "energy/match_groups.h"
#include "matching/match_parts.h"

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
long alignment_cost(const Part_matching& matching, const Aligned_shape& source, const Aligned_shape& target);

// The pairs, by index in the structural graphs.
std::vector<Part_correspondence> original_pairs(const Part_matching& matching, const Aligned_shape& source,
                                                const Aligned_shape& target);

// The most probable source part of a target part. Without roles: the matched one of most confidence, or else, with
// confidence 0, the one of least cost.
Part_correspondence likeliest_source(const Part_matching& matching, std::size_t target);

// A matching of one alignment of two shapes in the indices of another one. \pre both have the same parts
Part_matching renumbered(const Part_matching& matching, const Aligned_shape& source, const Aligned_shape& new_source,
                         const Aligned_shape& target, const Aligned_shape& new_target);

} // namespace CGAL::Shape_correspondence::internal

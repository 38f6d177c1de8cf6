// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "energy/Matching_problem.h"

#include <CGAL/Shape_correspondence/Correspondence.h>

#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

// The correspondence that an assignment of labels gives, with its energy, but without lists of unmatched parts.
// \param direction which shape is the source of the problem \param turns quarter turns of the target
// \param min_marginals by group; may be empty
Correspondence rate(const Matching_problem& problem, const Assignment& assignment, Direction direction, int turns,
                    const std::vector<double>& min_marginals = {});

// Lists the parts without a pair.
void collect_unmatched(std::size_t source_parts, std::size_t target_parts, Correspondence& correspondence);

} // namespace CGAL::Shape_correspondence::internal

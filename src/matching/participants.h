// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "energy/Matching_problem.h"

#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

// The shape as far as it takes part. \param chosen indices in the structural graph; empty: all
// \throw Invalid_input if the shape lacks one of them
Matching_problem::Shared_shape participating(Matching_problem::Shared_shape shape,
                                             const std::vector<std::size_t>& chosen);

// Which of the parts take part, of equally prominent ones the same in every alignment. \param shape in its own frame
std::vector<std::size_t> participants(const Matching_problem::Shared_shape& shape,
                                      const std::vector<std::size_t>& chosen, int maximum_parts);

// Parts that are pinned are groups of their own.
Matching_problem::Shared_shape regrouped(const Matching_problem::Shared_shape& shape,
                                         const std::vector<std::vector<std::size_t>>& sets);

} // namespace CGAL::Shape_correspondence::internal

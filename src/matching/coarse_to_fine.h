// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "energy/Matching_problem.h"

#include <CGAL/Shape_correspondence/Search_options.h>

namespace CGAL::Shape_correspondence::internal {

/// Whether shapes are to be matched coarse to fine, and have more parts than the coarse match takes.
bool is_coarse_to_fine(const Aligned_shape& source, const Aligned_shape& target, const Search_options& options);

/// What the groups of the deformed shape may become after a coarse match (paper, section 3, "coarse-to-fine"): the
/// `Search_options::coarse_to_fine` most prominent parts of either shape are matched first. Every group is near to the
/// coarse groups that are nearest, by contacts, to itself or to a group that it touches. It may become the target
/// groups that are near to the images of these. O(n²) for n groups.
/// \param source the shape that is deformed
/// \param options with `matching` for this direction
/// \return empty unless `is_coarse_to_fine()` \throw Out_of_time, Too_large
Group_candidates coarse_candidates(const Matching_problem::Shared_shape& source,
                                   const Matching_problem::Shared_shape& target, const Search_options& options,
                                   const Deadline& deadline = Deadline());

} // namespace CGAL::Shape_correspondence::internal

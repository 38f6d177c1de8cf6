// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "energy/Matching_problem.h"

#include <CGAL/Shape_correspondence/Search_options.h>
#include <CGAL/Shape_correspondence/Search_result.h>

namespace CGAL::Shape_correspondence::internal {

/// The options for an exact search that ends at the deadline. \pre the deadline is not over
Exact_options until(const Deadline& deadline, Exact_options options);

/// The best `Search_options::solutions` of a problem by the method of the options, `BEAM` or `EXACT`.
/// \throw Out_of_time, Too_large
Search_result search(const Matching_problem& problem, const Search_options& options, const Deadline& deadline);

/// Whether coarse-to-fine matching is wanted, and a shape has more parts than the coarse match takes.
bool is_coarse_to_fine(const Aligned_shape& source, const Aligned_shape& target, const Search_options& options);

/// The target groups allowed for every group of the deformed shape after a coarse match (paper, section 3,
/// "coarse-to-fine"): the `Search_options::coarse_to_fine` most prominent parts of each shape are matched first. A
/// group depends on the coarse groups nearest, by contacts, to itself or to a group in contact with it; it may become a
/// target group that is near an image of these. O(n²) for n groups.
/// \param source the shape that is deformed
/// \param options options, whose `energy` is set for this direction of the deformation
/// \return empty unless `is_coarse_to_fine()` \throw Out_of_time, Too_large
Group_candidates coarse_candidates(const Matching_problem::Shared_shape& source,
                                   const Matching_problem::Shared_shape& target, const Search_options& options,
                                   const Deadline& deadline = Deadline());

} // namespace CGAL::Shape_correspondence::internal

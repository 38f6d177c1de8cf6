// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "base/deadline.h"
#include "energy/Matching_problem.h"

#include <CGAL/Shape_correspondence/Beam_options.h>
#include <CGAL/Shape_correspondence/Search_result.h>

namespace CGAL::Shape_correspondence {

/// Pruned beam search (paper, section 5): groups are assigned one by one, from the best-connected one outwards, so that
/// no state is found twice. Partial solutions are rated by `internal::Partial_energy`. The k best expansions of every
/// solution are kept, and the K best of every level; ties go to the better parent, then to the lower label. A group may
/// take any of its labels at any level, so that the search always ends with up to K complete assignments.
///
/// When the time is over, only the first expansion of every level is kept.
/// \throw Invalid_input if the width or the number of expansions is under 1
Search_result beam_search(const Matching_problem& problem, const Beam_options& options = {},
                          const internal::Deadline& deadline = internal::Deadline());

} // namespace CGAL::Shape_correspondence

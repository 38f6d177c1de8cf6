// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/Blend_part.h"
#include "blend/unlike_pairs.h"

#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// The parts that become of parts of the source that become parts of the target together, by distance fields, as they
/// have no map onto each other: one for every set of parts that pairs connect, if it holds together on its way.
/// \param torn those of the pairs that have no map; others are unlike
std::vector<Blend_part> part_sets(const Blend_stage& stage, const Part_pairs& pairs, const Torn_pairs& torn);

} // namespace CGAL::Shape_correspondence::internal

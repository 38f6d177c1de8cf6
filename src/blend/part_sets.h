// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/Blend_part.h"
#include "blend/unlike_pairs.h"

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// Parts of the source that become parts of the target together, by distance fields, as they have no map onto each
/// other.
struct Part_set
{
  std::array<std::vector<std::size_t>, 2> parts; ///< by end, in order
  Blend_obstacle reason = Blend_obstacle::NONE;  ///< why there is no map
};

/// The sets of parts that pairs connect.
/// \param torn those of the pairs that have no map; others are unlike
std::vector<Part_set> connected_sets(const Blend_stage& stage, const Part_pairs& pairs, const Torn_pairs& torn);

/// Adds the parts that become of sets, but of those that do not hold together on their way, mirror images together.
void add_sets(const Blend_stage& stage, const std::vector<Part_set>& sets, std::vector<Blend_part>& parts);

} // namespace CGAL::Shape_correspondence::internal

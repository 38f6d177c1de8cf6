// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/Blend_part.h"
#include "blend/Field_morph.h"
#include "blend/unlike_pairs.h"

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// Parts of the source that become parts of the target together, by distance fields, as they have no map onto each
/// other.
struct Part_set
{
  std::array<std::vector<std::size_t>, 2> parts; ///< by end, in order
  Blend_obstacle reason = Blend_obstacle::NONE;  ///< why there is no map
  std::shared_ptr<const Field_morph> morph;      ///< once it is made
};

/// The sets of parts that pairs connect.
/// \param torn those of the pairs that have no map; others are unlike
std::vector<Part_set> connected_sets(const Blend_stage& stage, const Part_pairs& pairs, const Torn_pairs& torn);

/// Makes the morphs of sets.
/// \return those that do not hold together on their way, mirror images together, which are taken out
std::vector<Part_set> take_broken(const Blend_stage& stage, std::vector<Part_set>& sets);

/// Adds the parts that become of sets. \pre their morphs are made
void add_sets(const Blend_stage& stage, const std::vector<Part_set>& sets, std::vector<Blend_part>& parts);

} // namespace CGAL::Shape_correspondence::internal

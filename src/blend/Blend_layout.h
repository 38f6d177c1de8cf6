// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/Unmatched_chain.h"

#include <array>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

class Blend_structure;

/// When each part's task begins and ends.
using Task_times = std::vector<std::array<double, 2>>;

/// Which unmatched parts move together, and when they come and go, by one of the schedules.
struct Blend_layout
{
  std::string name; ///< of the schedule
  std::vector<Unmatched_chain> chains;
  Task_times times; ///< by part
};

/// The names of all layouts: bodies from the ground up, from the top down, and none.
const std::vector<std::string>& layout_names();

/// All layouts of a blend that has its parts.
std::vector<Blend_layout> blend_layouts(const Blend_stage& stage, const Part_pairs& unlike,
                                        const Blend_structure& blend);

/// Unites bodies of a layout that come apart from what they touch, or from all the rest, on the way.
/// \return whether there are any
bool unite_open_bodies(const Blend_structure& blend, const Blend_layout& layout, Exchanged_bodies& bodies);

} // namespace CGAL::Shape_correspondence::internal

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "map/matched_members.h"
#include "shape/Triangle_tree.h"

#include <CGAL/Shape_correspondence/Blend_schedule.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

struct Blend_stage;

/// Parts without counterpart that give way to each other: those of the source go from the box around them to that
/// around those of the target, which take their place there.
struct Exchange_set
{
  std::array<std::vector<std::size_t>, 2> parts;     ///< by end
  std::array<contacts::Box, 2> boxes;                ///< around them; around the shapes if they are in other places
  Blend_exchange reason = Blend_exchange::UNMATCHED; ///< UNLIKE if some correspond
};

/// The sets of parts that do not morph but correspond and are near each other, or are in the same place of the box
/// around the whole; with what touches nothing but them. What corresponds to parts elsewhere is one set.
/// \param paired what morphs
/// \param unlike what corresponds but is too unlike to
std::vector<Exchange_set> exchange_sets(const Blend_stage& stage, const Part_pairs& paired, const Part_pairs& unlike);

} // namespace CGAL::Shape_correspondence::internal

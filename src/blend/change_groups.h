// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/Unmatched_chain.h"

#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// By part, its group, which comes and goes at one time, so that each takes the place of the other: chains and those
/// that they correspond to, mirror images, what stands, and what takes up most of the place of a part.
/// \param unlike pairs that correspond but do not morph
std::vector<std::size_t> change_groups(const Blend_stage& stage, const Part_pairs& unlike,
                                       const std::vector<Blend_part>& parts,
                                       const std::vector<Unmatched_chain>& chains);

} // namespace CGAL::Shape_correspondence::internal

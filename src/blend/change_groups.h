// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/Blend_part.h"
#include "blend/touches.h"

#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// By part, its group, which changes at one time. Old parts and new ones are in one group, so that these take the place
/// of those, if they correspond, if they stand on the ground, or if they are in one place. Mirror images are in one
/// group, and so are parts that touch each other and take no other part's place.
/// \param unlike pairs that correspond but do not morph
std::vector<std::size_t> change_groups(const Blend_stage& stage, const Part_pairs& unlike,
                                       const std::vector<Blend_part>& parts, const std::vector<Touch>& touches);

} // namespace CGAL::Shape_correspondence::internal

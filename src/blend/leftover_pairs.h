// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "map/matched_members.h"

namespace CGAL::Shape_correspondence::internal {

struct Blend_stage;

/// Pairs of parts that are in none of the given ones, alike in place and size, those that overlap most first.
Part_pairs leftover_pairs(const Blend_stage& stage, const Part_pairs& given);

/// All pairs of parts that are in none of the given ones and share their place.
Part_pairs leftover_links(const Blend_stage& stage, const Part_pairs& given);

} // namespace CGAL::Shape_correspondence::internal

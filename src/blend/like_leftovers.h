// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "map/matched_members.h"

namespace CGAL::Shape_correspondence::internal {

struct Blend_stage;

/// Pairs of parts that no pair has, but that are alike in place and size on the stage, such as the sides of one shelf
/// and the posts of another: every part in one at most, together as alike as can be.
Part_pairs like_leftovers(const Blend_stage& stage, const Part_pairs& paired);

} // namespace CGAL::Shape_correspondence::internal

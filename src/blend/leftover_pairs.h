// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "map/matched_members.h"

namespace CGAL::Shape_correspondence::internal {

struct Blend_stage;

/// Pairs of parts that neither morph nor correspond to others, alike in place and size, those that overlap most
/// first.
/// \param paired what morphs
/// \param unlike what corresponds but is too unlike to
Part_pairs leftover_pairs(const Blend_stage& stage, const Part_pairs& paired, const Part_pairs& unlike);

} // namespace CGAL::Shape_correspondence::internal

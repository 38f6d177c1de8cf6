// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "map/matched_members.h"

namespace CGAL::Shape_correspondence::internal {

struct Blend_stage;

/// Takes out the pairs whose parts, or pieces of them, would have to turn, to change their proportions or to travel
/// much to become each other: legs cut up for a star base, slats across spindles. With a pair of pieces go all
/// others of its parts, as a part is divided as a whole, and their mirror images; of these, whole parts that are alike
/// become each other, one to one.
/// \param torn pairs of pieces that are taken out, too
/// \return the pairs that were taken out
Part_pairs take_unlike_pairs(const Blend_stage& stage, const Part_pairs& torn, Part_pairs& paired);

/// Whether two whole parts are too unlike to become each other.
bool are_unlike(const Blend_stage& stage, std::size_t source, std::size_t target);

} // namespace CGAL::Shape_correspondence::internal

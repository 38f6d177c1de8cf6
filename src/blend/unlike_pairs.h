// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "map/matched_members.h"

#include <set>

namespace CGAL::Shape_correspondence::internal {

struct Blend_stage;
struct Pair_charts;

/// Pairs of parts whose surfaces have no map onto each other, or pieces of theirs.
using Torn_pairs = std::set<Part_pairs::value_type>;

/// Takes out the pairs whose parts, or pieces of them, would have to turn, to change their proportions or to travel
/// much to become each other: legs cut up for a star base, slats across spindles. With a pair of pieces go all
/// others of its parts, as a part is divided as a whole, and their mirror images.
/// \param torn pairs of pieces that are taken out, too
/// \return the pairs that were taken out
Part_pairs take_unlike_pairs(const Blend_stage& stage, const Torn_pairs& torn, Part_pairs& paired);

/// Pairs of parts that are in none of the given ones, alike in place and size, those that overlap most first.
Part_pairs leftover_pairs(const Blend_stage& stage, const Part_pairs& given);

/// Whether two parts take up the same place in the boxes around the shapes.
bool are_in_one_place(const Blend_stage& stage, std::size_t source, std::size_t target);

/// Whether what is in two boxes is too unlike to become each other.
bool are_unlike(const Blend_stage& stage, const Pair_charts& boxes);

/// The most alike of some pairs, every part in one at most, images with images.
Part_pairs most_alike(const Blend_stage& stage, const Part_pairs& pairs);

} // namespace CGAL::Shape_correspondence::internal

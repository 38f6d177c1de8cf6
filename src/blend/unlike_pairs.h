// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "map/matched_members.h"
#include "shape/Triangle_tree.h"

#include <array>
#include <cstddef>
#include <set>

namespace CGAL::Shape_correspondence::internal {

struct Blend_stage;

/// Pairs of parts whose surfaces have no map onto each other, or pieces of theirs.
using Torn_pairs = std::set<Part_pairs::value_type>;

/// The pairs that correspond but do not morph.
struct Unlike_pairs
{
  Part_pairs all;
  Torn_pairs torn; ///< and leftover ones that would be
};

/// Takes out the pairs whose parts, or pieces of them, would have to turn, to change their proportions or to travel
/// much to become each other: legs cut up for a star base, slats across spindles. With a pair of pieces go all
/// others of its parts, as a part is divided as a whole, and their mirror images.
/// \param torn pairs of pieces that are taken out, too
/// \return the pairs that were taken out
Part_pairs take_unlike_pairs(const Blend_stage& stage, const Torn_pairs& torn, Part_pairs& paired);

/// Pairs, and those of parts that are in none of them, alike in place and size: both correspond, but to others, too, or
/// neither has a counterpart.
Part_pairs with_leftovers(const Blend_stage& stage, const Unlike_pairs& unlike, Part_pairs paired);

/// Whether a way from one place to another, each from 0 to 1 in the box around its shape, is too far to travel.
/// \param size the length of what travels
/// \param wholes the boxes around the shapes
bool is_far(const Point& way, double size, const std::array<contacts::Box, 2>& wholes);

/// How much of the place of the smaller one of two parts is that of the other, in the boxes around the shapes: what is
/// more than `same_place` is in one place.
double shared_place(const Blend_stage& stage, std::size_t source, std::size_t target);
constexpr double same_place = 0.4;

} // namespace CGAL::Shape_correspondence::internal

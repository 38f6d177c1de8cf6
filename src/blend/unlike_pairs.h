// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "map/Piece_pair.h"
#include "shape/Triangle_tree.h"

#include <array>
#include <set>

namespace CGAL::Shape_correspondence::internal {

struct Blend_stage;

/// The pairs of parts that correspond but do not morph.
struct Unlike_pairs
{
  Part_pairs all;
  /// `torn`: pairs, also of leftover parts, without a faithful morph, or whose part would come off what it touches;
  /// `detached`: the latter ones.
  std::set<Part_pairs::value_type> torn, detached;
};

/// The change needed for a part, a piece, or the box around parts to become another. Lengths are over the height.
struct Difference
{
  /// \param are_whole whether the charts are of whole parts: then extents relative to those of the shapes are compared,
  /// too, and the smaller of both changes counts
  Difference(const Blend_stage& stage, const std::array<Part_chart, 2>& charts, bool are_whole = true);

  /// Whether the proportions change little.
  bool keeps_shape() const;
  /// Whether proportions and position change little, so that pieces of parts may morph.
  bool is_little() const;
  /// Whether the displacement is small enough for a whole part to morph, if it does not come off what it touches.
  bool is_possible() const;
  /// Whether the position changes moderately, so that a `Space_warp` may follow the boxes.
  bool stays_near() const;

  double change;  ///< sum of the absolute log ratios of the extents
  double stretch; ///< absolute log ratio of the longest extents
  double way;     ///< displacement of the centre relative to the shapes' bounding boxes
  double size;    ///< longest extent of both
  double whole;   ///< mean diagonal of the shapes
};

/// The pairs of parts that morph to each other:
///  - Of the pairs that correspond, all but those whose parts would move far, or whose pieces would change their
/// proportions or positions much: legs cut up for a star base, slats across spindles. As a part is divided as a whole,
/// all other pairs of its parts, and their mirror images, are dropped with such a pair.
///  - Leftover parts with similar position and size, unless one of them shares the place of another part nearly as
/// much: two parts that correspond, but also to others, or two without counterparts.
/// \param unlike its torn pairs are dropped; `all` is set
Part_pairs like_pairs(const Blend_stage& stage, const Part_pairs& paired, Unlike_pairs& unlike);

} // namespace CGAL::Shape_correspondence::internal

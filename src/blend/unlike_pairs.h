// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "map/Piece_pair.h"
#include "map/matched_members.h"
#include "shape/Triangle_tree.h"

#include <array>
#include <set>

namespace CGAL::Shape_correspondence::internal {

struct Blend_stage;

/// The pairs that correspond but do not morph.
struct Unlike_pairs
{
  Part_pairs all;
  /// Of these, and of leftover ones, those whose surfaces, or pieces of theirs, have no map.
  std::set<Part_pairs::value_type> torn;
};

/// How much has to happen to a part, a piece, or the box around several parts to become another. Lengths are over the
/// height.
struct Difference
{
  /// \param are_whole extents are also compared as shares of those of the whole, and differ as little as they do either
  /// way; not those of pieces
  Difference(const Blend_stage& stage, const std::array<Part_chart, 2>& charts, bool are_whole = true);

  /// Whether the shape stays much the same.
  bool keeps_shape() const;
  /// Whether that and the place do, so that the one may morph to the other.
  bool is_little() const;
  /// Whether the place is in the same region.
  bool stays_near() const;

  double change;  ///< of the extents, in logarithms, summed
  double stretch; ///< of the longest extent, in logarithms
  double way;     ///< of its middle, in the box around the whole
  double size;    ///< its longest extent
};

/// The pairs of parts that become each other:
/// - Of those that correspond, all but those whose parts, or pieces of them, would have to change their
///   proportions or to travel much: legs cut up for a star base, slats across spindles. As a part is divided as a
///   whole, a pair goes with all others of its parts, and with their mirror images.
/// - Leftover parts that are alike in place and size, if none of both is nearly as much in the place of another: two
///   that correspond, but to others, too, or two without counterparts.
/// \param unlike those that are torn become no parts; `all` is set
Part_pairs like_pairs(const Blend_stage& stage, const Part_pairs& paired, Unlike_pairs& unlike);

} // namespace CGAL::Shape_correspondence::internal

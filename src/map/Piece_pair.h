// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "map/matched_members.h"

#include <CGAL/Shape_correspondence/Correspondence.h>

#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

using Chart_box = Eigen::AlignedBox3d;

inline Chart_box whole_chart() { return Chart_box(Point::Constant(-1), Point::Constant(1)); }
inline bool is_whole(const Chart_box& box) { return box.contains(whole_chart()); }

/// Two parts, or pieces of parts, that are mapped to each other.
struct Piece_pair
{
  std::size_t source = 0, target = 0;
  Chart_box source_piece = whole_chart(), target_piece = whole_chart(); ///< in the chart coordinates of the parts
  /// From coordinates of the source's piece to those of the target's.
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
};

inline bool is_whole(const Piece_pair& pair) { return is_whole(pair.source_piece) && is_whole(pair.target_piece); }

/// How the charts of two parts are aligned.
enum class Pair_kind {
  SAME,       ///< two curves or two sheets: with each other
  LENGTHWISE, ///< a curve and a sheet: along the curve and the longer direction of the sheet
  BOXES       ///< a closed curve and any part: by their bounding boxes
};

/// The rotations of the cube to itself, the identity first.
std::vector<Eigen::Matrix3d> cube_rotations();

std::array<Part_chart, 2> piece_charts(const Piece_pair& pair, const Charted_shape& source,
                                       const Charted_shape& target);

/// The kind by charts: a part may have the chart of its mirror image, whose kind can differ.
Pair_kind pair_kind(const Piece_pair& pair, const Charted_shape& source, const Charted_shape& target);

/// The pairs of pieces for pairs of parts, in the same order.
std::vector<Piece_pair> piece_pairs(const Charted_shape& source, const Charted_shape& target, const Part_pairs& paired);

/// The pairs of pieces for a correspondence, ordered by source part, then target part.
std::vector<Piece_pair> piece_pairs(const Charted_shape& source, const Charted_shape& target,
                                    const Correspondence& correspondence);

/// The charts between which a pair of pieces is mapped: both of one kind, with corresponding coordinates.
struct Pair_charts
{
  Part_chart source, target;
};

Pair_charts pair_charts(const Piece_pair& pair, const Charted_shape& source, const Charted_shape& target,
                        const Points& source_piece, const Points& target_piece);

} // namespace CGAL::Shape_correspondence::internal

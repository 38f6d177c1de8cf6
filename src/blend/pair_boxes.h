// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "map/Piece_pair.h"

#include <array>

namespace CGAL::Shape_correspondence::internal {

/// Straight charts of the boxes of two surfaces. A box has the axes of the world unless a part's own ones make it much
/// smaller; axes are paired for the least rotation over the symmetries of boxes.
/// \param own_axes of the surfaces, rotations
Pair_charts pair_boxes(const std::array<const Points*, 2>& surfaces, const std::array<Eigen::Matrix3d, 2>& own_axes);

/// The angle by which the one turns to become the other, in radians, and by how much that is more than the least one
/// over the symmetries of boxes.
double turn(const Pair_charts& charts);
double needless_turn(const Pair_charts& charts);

} // namespace CGAL::Shape_correspondence::internal

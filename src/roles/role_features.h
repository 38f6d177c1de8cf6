// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "structure/align_shapes.h"

#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

// The features that roles are predicted from, in the unit box of the shape (each axis from 0 to 1 over its surface)
// unless the comment says otherwise: x to the left, y up, z to the front. They do not tell left from right. "Its" means
// the part's.
enum Role_feature : int {
  ON_GROUND, // 1 or 0
  LOWEST_HEIGHT,
  HIGHEST_HEIGHT,
  MIDDLE_HEIGHT,
  EXTENT_UP, // extent of its box along y
  LOWEST_DEPTH,
  HIGHEST_DEPTH,
  MIDDLE_DEPTH,
  EXTENT_DEPTH,        // extent along z
  EXTENT_SIDEWAYS,     // extent along x
  OFF_MIDDLE,          // distance of the middle of its box from the middle plane, over half the width of the shape
  FARTHEST_OFF_MIDDLE, // distance of the farthest side of its box from that plane, over half the width
  SPANS_MIDDLE,        // 1 or 0: reaches over both sides of the middle plane
  DIAGONAL,            // diagonal of its box over that of the shape's box, in the common frame
  HEIGHT,              // height of its box over the diagonal of the shape's box, in the common frame
  AREA,                // share of the surface of all parts
  SECOND_SIDE,
  THIRD_SIDE, // the sides of its box, over the longest one, in the common frame
  SECOND_LENGTH,
  THIRD_LENGTH, // root of a principal variance, over the largest, in the common frame
  SPREAD_SIDEWAYS,
  SPREAD_UP,
  SPREAD_DEPTH, // diagonal of the root of the covariance matrix, scaled to Frobenius norm 1
  TILT_SIDEWAYS,
  TILT_TO_FRONT,
  TILT_LEVEL,     // elements off the diagonal of that matrix: xy, yz, xz
  RANK_IN_HEIGHT, // share of the parts whose middle is lower, ties count half
  SIDEWAYS_OF_LARGEST,
  UP_OF_LARGEST,
  TO_FRONT_OF_LARGEST, // offsets of its middle from that of the part of most area
  SIDEWAYS_OF_NEIGHBOUR,
  UP_OF_NEIGHBOUR,
  TO_FRONT_OF_NEIGHBOUR, // offsets of its middle from that of the largest part that it touches
  SHARE_WITH_NEIGHBOUR,  // its area over the sum of both areas
  SHAPE_WIDTH,
  SHAPE_DEPTH, // width / (width + height) of the shape's box in the common frame; the same with its depth
  ROLE_FEATURE_COUNT
};

// One row for each part, by its index in the structural graph. A feature is a byte, 0 … 254 for 0 … 1, or for -1 … 1 if
// it is signed, so that rounding by a motion of the shape does not show.
using Role_features = Eigen::Array<std::uint8_t, Eigen::Dynamic, ROLE_FEATURE_COUNT, Eigen::RowMajor>;

// \param shape the graph, aligned so that it faces +z
Role_features role_features(const Structural_graph& graph, const Aligned_shape& shape);

// Side of the middle plane.
enum class Side { RIGHT = -1, NEITHER, LEFT };

// The side on which the centre of each part's box is, by index in the structural graph.
std::vector<Side> part_sides(const Aligned_shape& shape);

} // namespace CGAL::Shape_correspondence::internal

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_BASE_QUARTER_TURN_H
#define CGAL_SHAPE_CORRESPONDENCE_BASE_QUARTER_TURN_H

#include <Eigen/Core>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

// Quarter turn about y as an exact rotation: no rounding, so that a self-match costs exactly 0.
inline Eigen::Matrix3d quarter_turn(int turns)
{
  static constexpr int cosine[] = {1, 0, -1, 0};
  const int k = ((turns % 4) + 4) % 4;
  const double c = cosine[k], s = cosine[(k + 3) % 4];
  Eigen::Matrix3d turn;
  turn << c, 0, s, 0, 1, 0, -s, 0, c;
  return turn;
}

} // namespace internal
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_BASE_QUARTER_TURN_H

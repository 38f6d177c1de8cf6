// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <Eigen/Core>

namespace CGAL::Shape_correspondence::internal {

inline int within_a_turn(int quarter_turns) { return (quarter_turns % 4 + 4) % 4; }

/// Rotation about y by quarter turns, exact, so that matching a shape with itself costs exactly 0.
inline Eigen::Matrix3d quarter_turn(int turns)
{
  static constexpr int cosine[] = {1, 0, -1, 0};
  const int k = within_a_turn(turns);
  const double c = cosine[k], s = cosine[(k + 3) % 4];
  Eigen::Matrix3d turn;
  turn << c, 0, s, 0, 1, 0, -s, 0, c;
  return turn;
}

} // namespace CGAL::Shape_correspondence::internal

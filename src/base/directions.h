// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Points.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>

namespace CGAL::Shape_correspondence::internal {

/// A unit vector perpendicular to a unit direction, as close to y as possible, or to x if the direction is near y.
/// Unlike Eigen's `unitOrthogonal()` it does not depend on the last digits of a direction along a coordinate axis.
inline Point some_normal(const Point& direction)
{
  const double near = 0.8; // least cosine of the angle between y and a direction near it
  const Point towards = std::abs(direction.y()) < near ? Point::UnitY() : Point::UnitX();
  return (towards - direction.dot(towards) * direction).normalized();
}

/// A unit vector or its opposite, such that the first component in the order y, x, z that is not small is positive.
inline Point with_fixed_sign(const Point& direction)
{
  const double small = 0.1; // largest component whose sign does not decide
  for (const int axis : {1, 0, 2})
    if (std::abs(direction[axis]) > small) return direction[axis] > 0 ? direction : Point(-direction);
  return direction;
}

/// The rotation by the least angle from one direction to another. For opposite directions it is the half turn about the
/// image of the z axis under the Householder reflection that maps `from` to the x axis.
///
/// Bitwise equal to Eigen::Quaterniond::FromTwoVectors() except for opposite directions, for which that function would
/// instantiate a singular value decomposition in every file.
inline Eigen::Quaterniond least_rotation(const Point& from, const Point& to)
{
  constexpr double opposite = -1 + 1e-12; // cosine below which directions count as opposite
  const Point a = from.normalized(), b = to.normalized();
  const double cosine = b.dot(a);
  Eigen::Quaterniond result;
  if (cosine < opposite) {
    const Point normal = a + std::copysign(1., a.x()) * Point::UnitX(); // normal of the reflection plane
    result.w() = 0;
    result.vec() = Point::UnitZ() - normal * (a.z() / (1 + std::abs(a.x())));
    return result;
  }
  const double doubled_w = std::sqrt((1 + cosine) * 2);
  const Point axis = a.cross(b);
  result.vec() = axis * (1 / doubled_w);
  result.w() = doubled_w * 0.5;
  return result;
}

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

/// A direction near y, oblique to all axes, so that positions of different points along it are hardly ever equal.
inline Point generic_direction() { return Point(0.6, 1, 0.36).normalized(); }

} // namespace CGAL::Shape_correspondence::internal

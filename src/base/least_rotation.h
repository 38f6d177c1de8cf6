// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Points.h>

#include <Eigen/Geometry>

#include <cmath>

namespace CGAL::Shape_correspondence::internal {

/// The rotation by the least angle that turns one direction to another. For opposite ones it is the half turn about
/// what the Householder reflection that maps `from` to the x axis maps the z axis to.
///
/// Eigen::Quaterniond::FromTwoVectors() gives the same bits but for opposite directions, for whose sake it instantiates
/// a singular value decomposition: 7 s of compile time in every file that calls it.
inline Eigen::Quaterniond least_rotation(const Point& from, const Point& to)
{
  constexpr double opposite = -1 + 1e-12; // cosine
  const Point a = from.normalized(), b = to.normalized();
  const double cosine = b.dot(a);
  Eigen::Quaterniond result;
  if (cosine < opposite) {
    const Point normal = a + std::copysign(1., a.x()) * Point::UnitX(); // of the reflection
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

} // namespace CGAL::Shape_correspondence::internal

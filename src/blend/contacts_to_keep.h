// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/Blend_part.h"

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// A point of each of two parts. They are at one place where the parts touch.
struct Contact_points
{
  std::array<Carried_point, 2> points;
  std::array<Point, 2> offset = {Point::Zero(), Point::Zero()}; ///< by end, from the first point to the second

  /// The offset that is due at `t`.
  Point due_offset(double t) const { return (1 - t) * offset[0] + t * offset[1]; }
};

/// Two parts that touch at an end, and where. If they are apart at the other end, they part evenly.
struct Kept_contact
{
  std::array<std::size_t, 2> parts;
  std::vector<Contact_points> points;
  std::array<double, 2> gap = {0, 0}; ///< by end, between the surfaces

  /// How wide the gap may be at `t`.
  double allowed_gap(double t) const { return (1 - t) * gap[0] + t * gap[1]; }
};

/// The contacts of matched parts at either end.
/// \param tolerance what is nearer than this touches
std::vector<Kept_contact> contacts_to_keep(const Blend_stage& stage, const std::vector<Blend_part>& parts,
                                           double tolerance);

} // namespace CGAL::Shape_correspondence::internal

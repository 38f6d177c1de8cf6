// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Points.h>

#include <Eigen/Geometry>

#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// What takes a part of a box: where it is, middle and half extents along the axes of the box, in any unit.
struct Share
{
  Point middle, half;
};

/// Divides a box among shares as they are arranged: along the axis that they are spread over most, in proportion to
/// their extents; those of one place along it are divided on. What lies about one middle shares the box.
/// \return by share, its part of the box
std::vector<Eigen::AlignedBox3d> divide_box(const Eigen::AlignedBox3d& box, const std::vector<Share>& shares);

} // namespace CGAL::Shape_correspondence::internal

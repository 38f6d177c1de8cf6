// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Points.h>

#include <Eigen/Geometry>

#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// Centre and half extents of something that is to get a part of a box, along the axes of the box, in any unit.
struct Share
{
  Point middle, half;
};

/// Divides a box as shares are arranged: along the axis of their largest spread, in proportion to their extents, and
/// recursively among those at one place along it. Concentric shares get the same box.
/// \return by share, its part of the box
std::vector<Eigen::AlignedBox3d> divide_box(const Eigen::AlignedBox3d& box, const std::vector<Share>& shares);

} // namespace CGAL::Shape_correspondence::internal

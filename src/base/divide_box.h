// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Points.h>

#include <Eigen/Geometry>

#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// Centre and half extents, along the axes of a box, of an object that is to get a part of the box; in any unit.
struct Share
{
  Point middle, half;
};

/// Divides a box as the shares are arranged: along the axis of their largest spread, in proportion to their extents,
/// and recursively among shares at the same position along it. Concentric shares get the same box.
/// \return the box of every share
std::vector<Eigen::AlignedBox3d> divide_box(const Eigen::AlignedBox3d& box, const std::vector<Share>& shares);

} // namespace CGAL::Shape_correspondence::internal

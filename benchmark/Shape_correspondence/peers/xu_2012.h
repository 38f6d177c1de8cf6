// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "unit_box.h"

namespace CGAL::Shape_correspondence::peers {

/// K. Xu et al., *Fit and diverse: set evolution for inspiring 3D shape galleries*, 2012: shapes are aligned and scaled
/// to one box, and parts correspond fuzzily, the more the nearer they are by Hausdorff distance.
/// Simplified: the shapes' frames align them, instead of an optimization over all of a set.
inline Part_pairs match_xu_2012(const Boxed_shape& source, const Boxed_shape& target)
{
  constexpr double width = 0.2; // of the falloff, in the unit box
  constexpr double least_share = 0.3;
  const Eigen::MatrixXd distance = part_distances(source, target, hausdorff);
  return strong_entries((-(distance / width).array().square()).exp().matrix(), least_share);
}

} // namespace CGAL::Shape_correspondence::peers

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "unit_box.h"

namespace CGAL::Shape_correspondence::peers {

/// Every source part goes to the target part of least Hausdorff distance in the shapes' unit boxes.
inline Part_pairs match_nearest_parts(const Boxed_shape& source, const Boxed_shape& target)
{
  const Eigen::MatrixXd distance = part_distances(source, target, hausdorff);
  Part_pairs pairs;
  for (Eigen::Index i = 0; i < distance.rows(); ++i) {
    Eigen::Index j;
    distance.row(i).minCoeff(&j);
    pairs.emplace_back(i, j);
  }
  return pairs;
}

} // namespace CGAL::Shape_correspondence::peers

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_PEERS_NEAREST_PARTS_H
#define CGAL_SHAPE_CORRESPONDENCE_PEERS_NEAREST_PARTS_H

#include "unit_box.h"

namespace CGAL {
namespace Shape_correspondence {
namespace peers {

/// Matches every source part with the target part of least Hausdorff distance in the shapes' unit boxes.
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

} // namespace peers
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_PEERS_NEAREST_PARTS_H

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_PEERS_XU_2012_H
#define CGAL_SHAPE_CORRESPONDENCE_PEERS_XU_2012_H

#include "unit_box.h"

namespace CGAL {
namespace Shape_correspondence {
namespace peers {

/// K. Xu et al., *Fit and diverse: set evolution for inspiring 3D shape galleries*, 2012: shapes are aligned and scaled
/// to one box, and parts correspond with fuzzy weights, which decrease with their Hausdorff distance.
/// Simplified: the shapes' frames align them, instead of an optimization over all of a set.
inline Part_pairs match_xu_2012(const Boxed_shape& source, const Boxed_shape& target)
{
  constexpr double width = 0.2; // of the Gaussian of distances, in unit boxes
  constexpr double least_share = 0.3;
  const Eigen::MatrixXd distance = part_distances(source, target, hausdorff);
  return strong_entries((-(distance / width).array().square()).exp().matrix(), least_share);
}

} // namespace peers
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_PEERS_XU_2012_H

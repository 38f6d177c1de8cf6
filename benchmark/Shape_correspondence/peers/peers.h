// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "assignment.h"
#include "fused_gromov_wasserstein.h"
#include "kim_2013.h"
#include "tevs_2014.h"
#include "zheng_2014.h"

#include <string>

namespace CGAL::Shape_correspondence::peers {

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

struct Named_peer
{
  std::string name, simplified; ///< name, and simplifications against the paper; for tables
  Peer match;
};

/// Other methods for the same task, written from the descriptions in their papers.
inline std::vector<Named_peer> all_peers()
{
  return {{"nearest parts in unit boxes", "-", pairwise(match_nearest_parts)},
          {"Xu et al. 2012", "frames align the shapes, not a set-wide optimization", pairwise(match_xu_2012)},
          {"Zheng et al. 2014", "arrangements of two groups; votes in place of clusters", match_zheng_2014},
          {"Kim et al. 2013", "one template, labels of whole parts, no manual start", match_kim_2013},
          {"Tevs et al. 2014", "spectral matching, arrangements by offsets and contacts", pairwise(match_tevs_2014)},
          {"optimal assignment, chamfer", "-", pairwise(match_by_assignment)},
          {"fused Gromov-Wasserstein", "-", pairwise(match_by_fused_gromov_wasserstein)}};
}

} // namespace CGAL::Shape_correspondence::peers

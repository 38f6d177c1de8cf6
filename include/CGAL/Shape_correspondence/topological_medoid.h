// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_TOPOLOGICAL_MEDOID_H
#define CGAL_SHAPE_CORRESPONDENCE_TOPOLOGICAL_MEDOID_H

#include <Eigen/Core>

#include <cstddef>
#include <functional>

namespace CGAL {
namespace Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceSets
/// The shape of a set that has the least sum of distances to the others (paper, section 6.1): its representative.
/// Of equal sums the first shape is taken. O(n²).
/// \param distances symmetric, as `symmetric_distances()` makes them
/// \pre there is a shape
std::size_t topological_medoid(const Eigen::Ref<const Eigen::MatrixXd>& distances);

/// \ingroup PkgShapeCorrespondenceOptions
/// Options of `sampled_medoid()`.
struct Sampled_medoid_options
{
  /// Largest probability that the result is not the medoid, in [0, 1); 0: it is the medoid.
  double failure_probability = 0;
  std::size_t batch = 16; ///< shapes that every candidate is compared with before some are set aside, at least 1
  unsigned seed = 0;      ///< seed of the order in which shapes are drawn
};

/// \ingroup PkgShapeCorrespondenceSets
/// What `sampled_medoid()` found.
struct Sampled_medoid
{
  std::size_t shape = 0;       ///< index of the medoid
  double mean_distance = 0;    ///< to the other shapes
  std::size_t evaluations = 0; ///< number of distances that were evaluated, out of n (n - 1) / 2
};

/// \ingroup PkgShapeCorrespondenceSets
/// The medoid without all distances. Candidates are compared with random shapes, and set aside if a confidence interval
/// shows that their mean distance is not the least (successive elimination as in BanditPAM; Tiwari et al. 2020). All
/// distances of the remaining ones are evaluated. With a failure probability of 0, each one set aside is then refuted:
/// the sum of some of its distances exceeds the sum of all distances of the best one. So the result is that of
/// `topological_medoid()`. Deterministic; O(n²) memory.
/// \param n the number of shapes
/// \param distance symmetric and not negative; called at most once for a pair, the smaller index first
/// \param options the probability of failure, and how shapes are drawn
/// \pre `n > 0`
/// \throw Invalid_input if a distance is negative or not a number, or an option is out of its range
Sampled_medoid sampled_medoid(std::size_t n, const std::function<double(std::size_t, std::size_t)>& distance,
                              const Sampled_medoid_options& options = {});

} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_TOPOLOGICAL_MEDOID_H

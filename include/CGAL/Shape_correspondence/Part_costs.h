// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_PART_COSTS_H
#define CGAL_SHAPE_CORRESPONDENCE_PART_COSTS_H

#include <CGAL/Shape_correspondence/align_shapes.h>
#include <CGAL/Shape_correspondence/config.h>
#include <CGAL/Shape_correspondence/part_assemblies.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {

/// What it costs that one part stands for another. Lengths are in the unit box of either shape: each axis of the common
/// frame runs from 0 to 1 over the shape, so that a low chair and a high one compare.
struct Part_cost_weights
{
  double overlap = 2;  ///< the share of the smaller part's box that lies outside of the other one's
  double extent = 0.7; ///< |log of the ratio of the boxes' sides|, summed over the axes
  double ground = 1.5; ///< one stands on the ground and the other does not; half of it for boards from side to side
  double side = 3;     ///< distance of the boxes' centres sideways
  double front = 3.5;  ///< the same, to the front
  double orientation = 1.5; ///< Frobenius distance of the normalized square roots of the surfaces' covariances
  double chamfer = 2;       ///< mean distance of a point of either surface from the other surface
  double contacts = 2;      ///< the share of the parts that they touch which do not stand for one another
  double link = 50;         ///< one is a link of a chain and the other is not (`Part_assemblies::is_link`)
};

/// The cost of every part of the source (row) standing for every part of the target (column), by index of the aligned
/// shapes. Symmetric: with the shapes swapped, the transposed matrix.
///
/// The boxes are compared as they are and after either shape was warped towards the other, axis by axis, where the most
/// alike parts ask for it; the three are averaged. A part shares in how alike its symmetry group is to the other's, and
/// a group of `whole_group_size` parts or more, or a panel (`Part_assemblies`), may cost less as a whole (legs for a
/// pedestal, slats for a board). How well the parts that two parts touch stand for one another goes by these costs.
/// O(n m k²) for n and m parts with k = `surface_samples` points each.
Eigen::MatrixXd part_costs(const Aligned_shape& source, const Aligned_shape& target,
                           const Part_cost_weights& weights = {});

/// How unlike the parts of one shape are among each other, by the same costs as they are.
Eigen::MatrixXd part_costs(const Aligned_shape& shape, const Part_cost_weights& weights = {});

/// The cost of two sets of parts: the mean of what every part costs with the one of the other set that it costs least
/// with, averaged over both sets. \pre neither is empty
double set_cost(const Eigen::MatrixXd& costs, const std::vector<std::size_t>& rows,
                const std::vector<std::size_t>& columns);

/// How badly two shapes go together: the mean of the least cost of every source part, and that of every target part,
/// added. \pre the matrix has rows and columns
double mean_least_cost(const Eigen::MatrixXd& costs);

} // namespace Shape_correspondence
} // namespace CGAL

#ifndef CGAL_SHAPE_CORRESPONDENCE_COMPILED
#include <CGAL/Shape_correspondence/internal/Part_costs_impl.h>
#endif

#endif // CGAL_SHAPE_CORRESPONDENCE_PART_COSTS_H

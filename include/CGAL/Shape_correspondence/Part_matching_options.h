// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

// Values were chosen on labelled and generated shapes. Values fitted by coordinate descent scored less on categories
// that were left out of the fit (the manual's page on accuracy).

#ifndef CGAL_SHAPE_CORRESPONDENCE_PART_MATCHING_OPTIONS_H
#define CGAL_SHAPE_CORRESPONDENCE_PART_MATCHING_OPTIONS_H

#include <CGAL/Shape_correspondence/Role_model.h>

#include <cstddef>

namespace CGAL {
namespace Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceOptions
/// Weights of the terms in the cost of substituting one part for another. Lengths are fractions of the extents of the
/// shapes: along each axis of the common frame, either shape extends from 0 to 1. Weights are not negative; 0 switches
/// a term off.
struct Part_cost_weights
{
  /// share of the smaller bounding box that lies outside of the other one
  double overlap = 2;
  /// |log of the ratio of the sides of the bounding boxes|, summed over the axes
  double extent = 0.7;
  /// one part stands on the ground and the other does not; half for upright boards
  double ground = 1.5;
  /// level distance of the centres of the bounding boxes, summed over the axes
  double place = 3.2;
  /// Frobenius distance of the normalized square roots of the covariances of the surfaces
  double orientation = 1.5;
  /// mean distance of points of either surface from the other one
  double chamfer = 2;
};

/// \ingroup PkgShapeCorrespondenceOptions
/// Options of `Search_method::PARTS`. Costs are in the unit of `Part_cost_weights`, lengths as there. They are not
/// negative; `tolerance`, `anchor` and `warp_width` are above 0.
struct Part_matching_options : Role_options
{
  Part_cost_weights weights; ///< weights of the terms of a cost
  /// Cost. Added where a part corresponds to a panel or a regular arrangement as a whole.
  double whole = 1;
  /// Length. What is shorter is as good as 0: added to the sides of bounding boxes, and the height up to which a part
  /// stands on the ground. Parts that pair one to one at no more than this cost are the same.
  double tolerance = 0.03;
  /// Likelihood, in [0, 1]. Pairs above it warp one shape towards the other; staying in place has this weight.
  double anchor = 0.2;
  /// Length. Standard deviation of the influence of such a pair.
  double warp_width = 0.15;
  /// Cost. A pair is matched if its cost is the least one of either part and exceeds the least costs of both parts by
  /// at most this sum. Smaller values give fewer pairs of higher precision.
  double excess = 1.5;
  /// Cost. The same bound for pairs that decide which sets of parts correspond.
  double confident_excess = 0.5;
  /// Share. A seat or table top covers at least this much of the shape as seen from above, and is no thicker than this
  /// much of its shorter side.
  double main_surface = 0.3;
  /// Length. What lies in one side of the shape is no thicker, and no farther from it.
  double side_depth = 0.1;
  /// Length. A wider part on the ground is a wall, not a leg.
  double wall_width = 0.7;
  /// Count, at least 2. A regular arrangement has this number of parts or more.
  std::size_t repetition = 3;
  bool panels = true;  ///< match panels as sets: rows of parts, and boards in one side of the shape
  bool support = true; ///< match the parts that support a seat or table top as a set
};

} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_PART_MATCHING_OPTIONS_H

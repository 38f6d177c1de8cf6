// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

// Values were chosen on labelled and generated shapes. Values fitted by coordinate descent gave lower scores on
// categories left out of the fit (manual, "Accuracy").

#ifndef CGAL_SHAPE_CORRESPONDENCE_PART_MATCHING_OPTIONS_H
#define CGAL_SHAPE_CORRESPONDENCE_PART_MATCHING_OPTIONS_H

#include <CGAL/Shape_correspondence/Role_model.h>

#include <cstddef>

namespace CGAL::Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceOptions
/// Weights, not negative, of the terms in the cost of substituting one part for another; 0 switches a term off. Lengths
/// are relative to the extents of the shapes: along each axis of the common frame, each shape extends from 0 to 1.
struct Part_cost_weights
{
  /// Weight of the share of the smaller bounding box that lies outside of the other one.
  double overlap = 2;
  /// Weight of |log(ratio of the sides of the bounding boxes)|, summed over the axes.
  double extent = 0.7;
  /// Cost if only one of the parts stands on the ground; half of it if one of them is an upright board.
  double ground = 1.5;
  /// Weight of the horizontal distance of the centres of the bounding boxes, summed over the two axes.
  double place = 3.2;
  /// Weight of the Frobenius distance of the normalized square roots of the covariance matrices of the surfaces.
  double orientation = 1.5;
  /// Weight of the mean distance of points of either surface from the other one.
  double chamfer = 2;
  /// Weight, at most 1000, of the cosine distance of the features of the parts, in [0, 2], if both shapes have some
  /// (`Shape_structure::features`).
  double features = 3;
};

/// \ingroup PkgShapeCorrespondenceOptions
/// Options of `Search_method::PARTS`. Costs and lengths are in the units of `Part_cost_weights`. All numbers
/// are not negative; `tolerance`, `anchor` and `warp_width` are above 0.
struct Part_matching_options : Role_options
{
  Part_cost_weights weights; ///< weights of the terms of a cost
  /// Cost added if a part corresponds to a panel or a regular arrangement as a whole.
  double whole = 1;
  /// Length that counts as 0: added to the sides of bounding boxes, and the height up to which a part stands on the
  /// ground. Parts that pair one to one at a cost of at most this number count as identical.
  double tolerance = 0.03;
  /// Likelihood, in [0, 1], above which a pair of parts takes part in warping one shape towards the other; also the
  /// weight of a zero displacement in the mean of the displacements.
  double anchor = 0.2;
  /// Standard deviation, a length, of the Gaussian by which the influence of a pair on the warp falls with distance.
  double warp_width = 0.15;
  /// Limit for (c - c1) + (c - c2), where c is the cost of a matched pair, and c1, c2 are the least costs of its two
  /// parts in any pair; c must be c1 or c2. Smaller values give fewer pairs of higher precision.
  double excess = 1.5;
  /// Limit for the same sum of differences as `excess`, for the pairs that decide which sets of parts correspond.
  double confident_excess = 0.5;
  /// Least share of the top view that a seat or table top covers; also its largest thickness over its shorter side.
  double main_surface = 0.3;
  /// Largest thickness of a board that belongs to a side of the shape, and its largest distance from that side.
  double side_depth = 0.1;
  /// Length: largest width of a part on the ground that is a leg rather than a wall.
  double wall_width = 0.7;
  /// Least number of parts of a regular arrangement, at least 2.
  std::size_t repetition = 3;
  bool panels = true;  ///< whether to match panels as sets: rows of parts, and boards in one side of the shape
  bool support = true; ///< whether to match the parts that support a seat or table top as a set
};

} // namespace CGAL::Shape_correspondence

#endif // CGAL_SHAPE_CORRESPONDENCE_PART_MATCHING_OPTIONS_H

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Points.h>

namespace CGAL::Shape_correspondence {

/// The paper's e, with the authors' value: a curve has e samples, a sheet e × e.
constexpr int samples_per_side = 6;

/// Largest number of surface points of a part that matching by parts uses.
constexpr int surface_samples = 32;

/// A part as the search sees it: the samples of its abstraction in the common frame.
struct Sampled_part
{
  enum class Kind { CURVE, CLOSED_CURVE, SHEET };

  Kind kind = Kind::CURVE;
  Points samples; ///< `samples_per_side` of a curve; as many rows and columns of a sheet, row by row
  Point centroid; ///< mean of the samples
  Points surface; ///< at most `surface_samples` points spread over the surface; equal to `samples` if it is unknown
  Eigen::VectorXd features; ///< column of `Shape_structure::features`; empty if there are none
};

} // namespace CGAL::Shape_correspondence

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_ESTIMATE_UP_H
#define CGAL_SHAPE_CORRESPONDENCE_ESTIMATE_UP_H

#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <array>

namespace CGAL::Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceShapes
/// An estimate of the upright axis of a shape.
struct Up_estimate
{
  Point up;              ///< a unit vector along an axis
  double confidence = 0; ///< probability that the axis is right, from 1/3 to 1
};

/// \ingroup PkgShapeCorrespondenceShapes
/// Estimates which of the axes x, y and z points up: the one along which the shape stands most stably, has the largest
/// horizontal surface, most of it above the ground, and differs most from itself turned upside down. It can be wrong
/// for shapes that can stand on several sides; models that are upside down or tilted are not detected. In case of a
/// tie, the first of y, z, x is taken. O(n log n) in the number of vertices.
/// \param shape the shape; its up direction is not used
/// \param odds_of_y prior odds of the y axis against each other axis, more than 0
/// \throw Invalid_input if the shape has no part, or the odds are out of range
Up_estimate estimate_up(const Segmented_shape& shape, double odds_of_y = 1);

/// \ingroup PkgShapeCorrespondenceShapes
/// Estimates the axes of two shapes of one category together, using that their proportions should be similar.
/// \param source,target the shapes
/// \param is_known whether the up direction of the source and of the target, along an axis, is known to be right
/// \param odds_of_y prior odds of the y axis against each other axis, more than 0
/// \throw Invalid_input see `estimate_up()`
std::array<Up_estimate, 2> estimate_up_of_pair(const Segmented_shape& source, const Segmented_shape& target,
                                               const std::array<bool, 2>& is_known, double odds_of_y = 1);

} // namespace CGAL::Shape_correspondence

#endif // CGAL_SHAPE_CORRESPONDENCE_ESTIMATE_UP_H

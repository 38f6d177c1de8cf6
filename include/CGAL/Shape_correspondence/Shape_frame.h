// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_SHAPE_FRAME_H
#define CGAL_SHAPE_CORRESPONDENCE_SHAPE_FRAME_H

#include <CGAL/Shape_correspondence/Points.h>

namespace CGAL::Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceShapes
/// The frame of a shape (paper, section 5, "Initial alignment"): in it the shape stands on the ground, is centred above
/// the origin, has height 1, and its dominant vertical mirror plane, if it has one, is x = 0. It is equivariant
/// under translation, uniform scaling and rotation about the upright axis, up to quarter turns, which are determined
/// when two shapes are aligned.
struct Shape_frame
{
  Point origin{0, 0, 0};                                 ///< point on the ground, in world coordinates
  Eigen::Matrix3d axes{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}; ///< columns: side x, up y, front z; a rotation
  double height = 1;                                     ///< extent along up; for a flat shape, its largest extent
  bool mirror_x = false;                                 ///< whether x = 0 is a mirror plane of the shape
  bool mirror_z = false;                                 ///< whether z = 0 is a mirror plane of the shape

  /// Converts the points `world` from world coordinates to coordinates of the frame.
  Points to_frame(const Points& world) const;
  /// Converts the points `local` from coordinates of the frame to world coordinates.
  Points to_world(const Points& local) const;
};

/// \ingroup PkgShapeCorrespondenceShapes
/// Finds the frame of a shape from points spread evenly over its surface. O(n log n) in the number of points.
/// \param surface points, any number above 0
/// \param up the upright direction, a unit vector
Shape_frame compute_shape_frame(const Points& surface, const Point& up);

} // namespace CGAL::Shape_correspondence

#endif // CGAL_SHAPE_CORRESPONDENCE_SHAPE_FRAME_H

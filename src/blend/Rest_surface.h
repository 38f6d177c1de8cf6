// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Points.h>

#include <array>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// A surface of a part at its end of the blend, as a reference for its deformations.
class Rest_surface
{
public:
  Rest_surface(const Points& points, const Eigen::Matrix3Xi& triangles);

  /// The area of the surface with deformed points.
  double area(const Points& points) const;

  /// The area, with deformed points, of the triangles that are folded back onto a neighbour that they smoothly continue
  /// at rest, or that are stretched much more than the whole surface.
  double torn_area(const Points& points) const;

  /// Some deformed points that are evenly distributed by area at rest.
  Points samples(const Points& points) const;

private:
  Eigen::Matrix3Xi triangles_;
  Point sizes_;                            ///< extents of its bounding box, bounded away from 0
  std::vector<std::array<int, 2>> smooth_; ///< pairs of adjacent triangles that smoothly continue each other
  Eigen::VectorXd longest_;                ///< for each triangle, the square of its longest edge
  std::vector<Eigen::Index> chosen_;       ///< triangles of the samples
};

} // namespace CGAL::Shape_correspondence::internal

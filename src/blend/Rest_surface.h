// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Points.h>

#include <array>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// A surface of a part of a blend as it is at its end of the blend, which it is compared with on the way.
class Rest_surface
{
public:
  Rest_surface(const Points& points, const Eigen::Matrix3Xi& triangles);

  bool is_closed() const { return is_closed_; }
  /// Of the surface where its points are elsewhere.
  double area(const Points& points) const;

  /// The area of the triangles that are folded back onto a neighbour that they continue at rest, or much longer than
  /// at rest where the whole surface is not.
  double torn_area(const Points& points) const;

  /// Some points evenly over the area, at rest.
  Points samples(const Points& points) const;

private:
  Eigen::Matrix3Xi triangles_;
  bool is_closed_;
  Point sizes_;                            ///< of the box around it, not quite 0
  std::vector<std::array<int, 2>> smooth_; ///< neighbouring triangles that continue each other
  Eigen::VectorXd longest_;                ///< by triangle, its longest edge, squared
  std::vector<Eigen::Index> chosen_;       ///< triangles
};

} // namespace CGAL::Shape_correspondence::internal

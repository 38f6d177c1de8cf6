// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Points.h>

namespace CGAL::Shape_correspondence::internal {

struct Convex_hull
{
  Points vertices;
  double volume = 0;   ///< 0 if the points lie in a plane
  bool is_box = false; ///< whether it is a box around the points, since CGAL could not compute their hull
};

Convex_hull convex_hull(const Points& points);

/// The convex hull of points as half-spaces.
class Hull_planes
{
public:
  /// \param thickness given to the hull in directions in which the points have none (in a plane or on a line)
  Hull_planes(const Points& points, double thickness);

  /// The share of points that are in the hull or at most `tolerance` outside of it.
  double share_inside(const Points& points, double tolerance) const;

private:
  Points normals_; ///< outwards, of length 1
  Eigen::VectorXd offsets_;
};

} // namespace CGAL::Shape_correspondence::internal

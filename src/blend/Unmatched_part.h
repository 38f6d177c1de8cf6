// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "map/Part_chart.h"

#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// A part without counterpart, which shrinks, or grows in reverse. It shrinks to where it is attached to other parts:
/// to a point or, between attachments far from each other, to a straight segment.
class Unmatched_part
{
public:
  /// \param anchors where it touches what it shrinks to; none: its own middle
  Unmatched_part(const Part_chart& chart, const Part_mesh& mesh, const std::vector<Point>& anchors);

  const Eigen::Matrix3Xi& triangles() const { return mesh_.triangles; }

  /// \param remaining how much of it there is, in [0, 1]
  Points points(double remaining) const { return remaining * mesh_.points + (1 - remaining) * vanished_; }

  /// Where a point of the part is then.
  Point place(const Point& p, double remaining) const { return remaining * p + (1 - remaining) * vanished(p); }

private:
  void fit_segment(const std::vector<Point>& anchors);
  Point vanished(const Point& p) const;

  Part_chart chart_;
  Part_mesh mesh_;
  Points vanished_;                                      ///< where the mesh's points are when nothing remains
  Point middle_ = Point::Zero(), slope_ = Point::Zero(); ///< of the anchors, along a coordinate
  Eigen::Index axis_ = 0;                                ///< that coordinate
  double low_ = 0, high_ = 0, mean_ = 0;                 ///< of the anchors' ones
};

} // namespace CGAL::Shape_correspondence::internal

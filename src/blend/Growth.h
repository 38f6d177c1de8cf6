// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "map/Part_chart.h"

#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// How an unmatched part comes and goes: it grows from the line through the places where it is held, along its own
/// curve or sheet, and is soon as thick as it will be.
class Growth
{
public:
  /// \param chart the chart of the part \param points its vertices
  /// \param holds the places where it is held, at least one
  Growth(const Part_chart& chart, const Points& points, const std::vector<Point>& holds);

  /// The points when a share, in [0, 1], of the part has grown.
  Points points(double share) const;

private:
  Point from(double at) const;

  Part_chart chart_;
  Points points_;
  Points coordinates_, offsets_; ///< of the points, see `Charted_mesh`
  int axis_ = 0;                 ///< coordinate along which the places are farthest apart
  std::vector<Point> stations_;  ///< coordinates of the line's ends and bends, sorted along the axis
};

} // namespace CGAL::Shape_correspondence::internal

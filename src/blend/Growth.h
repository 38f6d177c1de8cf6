// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "map/Part_chart.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// A place where an unmatched part is held.
struct Hold
{
  enum class By { MATCHED, CARRIER, GROUND, OTHER };

  Point place;
  By by = By::OTHER;       ///< a part that morphs, an unmatched part that carries it, the ground, or any other part
  std::size_t carrier = 0; ///< index of the carrier, if there is one
};

/// How an unmatched part comes and goes: it grows from the line through the places where it is held, along its own
/// curve or sheet, and is soon as thick as it will be. While a carrier grows as well, the place on it moves, and the
/// part goes with the place.
class Growth
{
public:
  /// \param chart the chart of the part
  /// \param holds where it is held, at least one
  Growth(const Part_chart& chart, const Points& points, const std::vector<Hold>& holds);

  /// How far the line has moved at each of its ends and bends, if `way_of` is how far a place on a carrier has moved.
  Points ways(const std::function<Point(const Hold&)>& way_of) const;

  /// The points when a share, in [0, 1], has grown. \param ways from `ways()`; empty: nothing has moved
  Points points(double share, const Points& ways = {}) const;
  /// How far a point of the surface is from its place in the full part.
  Point way(const Point& p, double share, const Points& ways) const;

private:
  /// Places that are near each other along the part, of which the line has one.
  struct Station
  {
    Point at; ///< coordinates
    std::vector<Hold> holds;
  };

  template <typename Value>
  Point along(double at, const Value& value) const;
  Point grown(const Point& k, const Point& offset, double share, const Points& ways) const;

  Part_chart chart_;
  Points points_;
  Points coordinates_, offsets_;  ///< in the chart, and from there to the points in the chart's frames
  int axis_ = 0;                  ///< coordinate along which the places are farthest apart
  std::vector<Station> stations_; ///< sorted along the axis
};

} // namespace CGAL::Shape_correspondence::internal

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "map/Piece_pair.h"

#include <CGAL/Shape_correspondence/Points.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// How the surface of a part, or of several, becomes that of its counterparts. There is one surface at any time: first
/// that of the source, last that of the target, with as many between as it takes, each of which moves.
class Part_morph
{
public:
  /// \param charts of both ends, between which it is laid on the way
  explicit Part_morph(Pair_charts charts) : charts_(std::move(charts)) {}
  virtual ~Part_morph() = default;

  /// When one surface takes over from the one before it, in order.
  virtual const std::vector<double>& changes() const = 0;
  int number_of_surfaces() const { return int(changes().size()) + 1; }
  /// The surface that there is at `t`.
  int surface(double t) const
  {
    return int(std::upper_bound(changes().begin(), changes().end(), t) - changes().begin());
  }

  virtual const Eigen::Matrix3Xi& triangles(int surface) const = 0;
  /// The points of a surface at `t`, also where it is not the one that there is.
  virtual Points points(int surface, double t) const = 0;

  /// Coordinates of a point at an end, and where such coordinates are at `t`, before the surfaces fit in exactly.
  virtual Point coordinates(int end, const Point& p) const { return chart(end).coordinates(p); }
  virtual Point place(const Point& coordinates, double t) const { return chart_at(t)(coordinates); }

protected:
  const Part_chart& chart(int end) const { return end == 0 ? charts_.source : charts_.target; }
  Part_chart chart_at(double t) const { return Part_chart::between(charts_.source, charts_.target, t); }

  Pair_charts charts_;
};

} // namespace CGAL::Shape_correspondence::internal

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "map/Part_chart.h"

#include <CGAL/Shape_correspondence/Segmented_shape.h>

namespace CGAL::Shape_correspondence::internal {

/// A part without counterpart, which thins where it is, or thickens in reverse: a rod or a ring to its curve, a plate
/// to its middle plane and then, across, to a line, or to its middle if it is about as wide as long; a block shrinks to
/// its middle.
class Thinning_part
{
public:
  Thinning_part(const Part_abstraction& part, const Points& control_points, const Part_chart& chart,
                const Part_mesh& mesh);

  const Eigen::Matrix3Xi& triangles() const { return mesh_.triangles; }

  /// The points when a share of the volume remains, in [0, 1].
  Points points(double remaining) const;
  /// Where a point of the part is then.
  Point place(const Point& p, double remaining) const;

private:
  /// What remains of a point's distances from the two of its places that follow.
  struct Scales
  {
    double to_middle, to_line;
  };
  struct Middle
  {
    Point middle, line; ///< the nearest places on the middle plane or curve, and on the line, or the point, that the
                        ///< plane narrows to
  };

  Scales scales(double remaining) const;
  Middle middle_of(const Point& p) const;

  enum class Form : char { ROD, RING, PLATE, BLOCK };

  Part_chart chart_;
  Part_mesh mesh_;
  Form form_;
  Points ring_; ///< the curve of a ring
  Points middles_, lines_;
};

} // namespace CGAL::Shape_correspondence::internal

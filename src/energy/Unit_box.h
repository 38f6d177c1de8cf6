// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "base/quantized.h"
#include "structure/align_shapes.h"

namespace CGAL::Shape_correspondence::internal {

// The unit box of a group: a direction in which the group has no extent counts as its middle.
class Unit_box
{
public:
  explicit Unit_box(const Eigen::AlignedBox3d& box)
  {
    constexpr double least_extent = 0.02; // of the shape's height; under it, sides are not told apart
    for (int axis = 0; axis < 3; ++axis) {
      const double extent = box.sizes()[axis];
      const bool has_none = extent < least_extent;
      scale_[axis] = has_none ? 0 : 1 / extent;
      origin_[axis] = has_none ? 0.5 : -box.min()[axis] / extent;
    }
  }

  Point operator()(const Point& p) const { return origin_ + scale_.cwiseProduct(p); }

private:
  Point scale_, origin_;
};

inline double quantized_distance(const Point& a, const Point& b) { return double(quantized((a - b).norm())); }

} // namespace CGAL::Shape_correspondence::internal

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "base/quantized.h"
#include "structure/align_shapes.h"

namespace CGAL::Shape_correspondence::internal {

// Maps points to the unit box of a group. An axis along which the group is flat maps to the middle, 0.5.
class Unit_box
{
public:
  explicit Unit_box(const Eigen::AlignedBox3d& box)
  {
    constexpr double least_extent = 0.02; // of the shape's height; a smaller one counts as flat
    for (int axis = 0; axis < 3; ++axis) {
      const double extent = box.sizes()[axis];
      const bool is_flat = extent < least_extent;
      scale_[axis] = is_flat ? 0 : 1 / extent;
      origin_[axis] = is_flat ? 0.5 : -box.min()[axis] / extent;
    }
  }

  Point operator()(const Point& p) const { return origin_ + scale_.cwiseProduct(p); }

private:
  Point scale_, origin_;
};

inline double quantized_distance(const Point& a, const Point& b) { return double(quantized((a - b).norm())); }

} // namespace CGAL::Shape_correspondence::internal

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_ENERGY_UNIT_BOX_H
#define CGAL_SHAPE_CORRESPONDENCE_ENERGY_UNIT_BOX_H

#include "base/quantized.h"
#include "structure/align_shapes.h"

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

// The unit box of a group: a direction in which the group has no extent counts as its middle.
class Unit_box
{
public:
  explicit Unit_box(const Aligned_shape::Group& group)
  {
    constexpr double least_extent = 0.02; // of the shape's height; under it, sides are not told apart
    for (int axis = 0; axis < 3; ++axis) {
      const double extent = group.box.sizes()[axis];
      const bool has_none = extent < least_extent;
      scale_[axis] = has_none ? 0 : 1 / extent;
      origin_[axis] = has_none ? 0.5 : -group.box.min()[axis] / extent;
    }
  }

  Point operator()(const Point& p) const { return origin_ + scale_.cwiseProduct(p); }

private:
  Point scale_, origin_;
};

inline double quantized_distance(const Point& a, const Point& b) { return double(quantized((a - b).norm())); }

} // namespace internal
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_ENERGY_UNIT_BOX_H

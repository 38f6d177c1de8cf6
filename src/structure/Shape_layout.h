// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "base/quantized.h"
#include "structure/align_shapes.h"

#include <algorithm>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

struct Axis_box
{
  Eigen::Array3d low, high;

  Eigen::Array3d sides() const { return high - low; }
  Eigen::Array3d centre() const { return (low + high) / 2; }
  double middle() const { return (low.y() + high.y()) / 2; }
};

inline Axis_box axis_box(const Points& points) { return {points.rowwise().minCoeff(), points.rowwise().maxCoeff()}; }

inline Axis_box joined(const Axis_box& a, const Axis_box& b) { return {a.low.min(b.low), a.high.max(b.high)}; }

inline bool is_less(double a, double b) { return quantized(a) < quantized(b); }

inline std::vector<std::vector<std::size_t>> touching_parts(const Aligned_shape& shape)
{
  std::vector<std::vector<std::size_t>> result(shape.parts.size());
  for (const Aligned_shape::Contact& contact : shape.contacts) {
    result[contact.parts[0]].push_back(contact.parts[1]);
    result[contact.parts[1]].push_back(contact.parts[0]);
  }
  return result;
}

// The bounds of a shape, the parts that stand on the ground, and the contacts between parts.
struct Shape_layout
{
  std::vector<Axis_box> boxes;
  Axis_box bounds; // bounding box of the shape
  std::vector<char> is_on_ground;
  std::vector<std::vector<std::size_t>> neighbours;

  // \param tolerance distance from the ground up to which a part stands on it, over the height of the shape
  Shape_layout(const Aligned_shape& shape, double tolerance) : neighbours(touching_parts(shape))
  {
    for (const Sampled_part& part : shape.parts)
      boxes.push_back(axis_box(part.surface));
    bounds = boxes.front();
    for (const Axis_box& box : boxes)
      bounds = joined(bounds, box);
    for (const Axis_box& box : boxes)
      is_on_ground.push_back(is_less(box.low.y() - bounds.low.y(), tolerance * bounds.sides().y()));
  }

  // The part and all parts connected to it by chains of allowed steps between parts in contact, ascending.
  template <typename Is_step>
  std::vector<std::size_t> connected(std::size_t first, const Is_step& is_step) const
  {
    std::vector<char> is_found(boxes.size(), 0);
    std::vector<std::size_t> result{first};
    is_found[first] = 1;
    for (std::size_t k = 0; k < result.size(); ++k)
      for (std::size_t next : neighbours[result[k]])
        if (!is_found[next] && is_step(result[k], next)) {
          is_found[next] = 1;
          result.push_back(next);
        }
    std::sort(result.begin(), result.end());
    return result;
  }
};

} // namespace CGAL::Shape_correspondence::internal

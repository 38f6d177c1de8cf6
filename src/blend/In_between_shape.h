// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/Blend_structure.h"

#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// The surfaces of the parts of a blend at a time strictly between its ends. Parts and surfaces are given by index.
///
/// *Layout*: matched parts move linearly from their places at one end to those at the other. Unmatched parts follow the
/// warps of the ends. Then the whole is stretched vertically to stand with the interpolated height.
struct In_between_shape
{
  /// \param tasks the tasks with their times; if empty, all parts of both ends are present in full size
  In_between_shape(const Blend_structure& blend, const std::vector<Blend_task>& tasks, double t);

  const Blend_structure& blend;
  double time;
  std::vector<int> surfaces;  ///< for each part, the index of its present surface, or -1
  std::vector<Points> points; ///< for each part, the points of its present surface

  bool is_there(std::size_t part) const { return surfaces[part] >= 0; }
  /// The interpolated height of the whole.
  double due_height() const
  {
    return (1 - time) * blend.stage.boxes[0].max().y() + time * blend.stage.boxes[1].max().y();
  }
  /// The points of a surface of a part at this time, even if it is not the present one.
  Points points_of(std::size_t part, int surface) const;
  /// The surfaces of the parts that are present.
  std::vector<Seen_surface> seen() const;
  Blend_quality quality() const;

private:
  Points grown(std::size_t part, const std::vector<Blend_task>& tasks);
  void place_unmatched(const std::vector<Blend_task>& tasks);
  void fill_the_height();
  void stretch(Points& surface) const { surface.row(1) = (scale_ * surface.row(1)).array() + shift_; }

  double scale_ = 1, shift_ = 0; ///< scale and offset of the vertical stretch
};

} // namespace CGAL::Shape_correspondence::internal

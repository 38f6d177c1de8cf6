// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/Blend_structure.h"

#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// The surfaces of the parts of a blend at a time strictly between its ends. Parts and surfaces are named by index.
///
/// *Layout*: matched parts go straight and evenly from where they are at the one end to where they are at the other.
/// Unmatched ones ride on the warps of the ends. Then the whole is stretched so that it stands and is as high as is
/// due.
struct In_between_shape
{
  /// \param tasks none: all parts of both ends are there as a whole
  In_between_shape(const Blend_structure& blend, const std::vector<Blend_task>& tasks, double t);

  const Blend_structure& blend;
  double time;
  std::vector<int> surfaces;  ///< by part, the one of its surfaces that there is, or -1
  std::vector<Points> points; ///< by part, of that surface

  bool is_there(std::size_t part) const { return surfaces[part] >= 0; }
  /// The height that the whole is to fill, from the ground.
  double due_height() const
  {
    return (1 - time) * blend.stage.boxes[0].max().y() + time * blend.stage.boxes[1].max().y();
  }
  /// The points of a surface of a part, also where it is at this time if it is not the one that there is.
  Points points_of(std::size_t part, int surface) const;
  /// The parts that are there.
  std::vector<Seen_surface> seen() const;
  Blend_quality quality() const;

private:
  void place_unmatched(const std::vector<Blend_task>& tasks);
  void fill_the_height();
  void stretch(Points& surface) const { surface.row(1) = (scale_ * surface.row(1)).array() + shift_; }

  double scale_ = 1, shift_ = 0; ///< by which the whole is stretched
};

} // namespace CGAL::Shape_correspondence::internal

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Affine_motion.h"
#include "blend/in_between_steps.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::internal {
namespace {

/// What a part is attached to, as handles that draw it there.
std::vector<Handle> handles_of(const In_between_shape& shape, std::size_t part)
{
  std::vector<Handle> result;
  for (const Attachment& on : shape.part(part).attachments) {
    const Point there = on.place.of(shape.points(on.part, on.surface), shape.part(on.part).triangles(on.surface));
    result.push_back({shape.part(part).remaining_place(on.at, shape.remaining(part)), there - on.at});
  }
  return result;
}

/// Moves points as handles ask for, in rounds that each leave less to do.
void follow(std::vector<Handle> handles, double size, Points& points)
{
  constexpr int rounds = 4;
  Stretch stretch;
  for (int round = 0; round < rounds; ++round) {
    const Affine_motion motion = stretch.bounded(fitted_motion(handles, size));
    motion.apply(points);
    for (Handle& handle : handles) {
      const Point step = motion.displacement(handle.at);
      handle.at += step;
      handle.displacement -= step;
    }
  }
}

} // namespace

void place_unmatched_parts(In_between_shape& shape)
{
  for (std::size_t i = 0; i < shape.number_of_parts(); ++i) {
    const Blend_part& part = shape.part(i);
    if (part.morph) continue;
    Points points = part.remaining_points(shape.remaining(i));
    const double size = std::max(box_of(points).diagonal().norm(), In_between_shape::least_stretched * part.size);
    follow(handles_of(shape, i), size, points);
    points.row(1).array() += std::max(0., shape.ground() - points.row(1).minCoeff());
    shape.set_unmatched(i, std::move(points));
  }
  symmetrise_boxes(shape, false);
  for (std::size_t i = 0; i < shape.number_of_parts(); ++i)
    if (shape.part(i).unmatched) symmetrise_surfaces(shape, i);
}

} // namespace CGAL::Shape_correspondence::internal

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/in_between_steps.h"

#include "blend/Affine_motion.h"

#include <algorithm>
#include <limits>

namespace CGAL::Shape_correspondence::internal {
namespace {

/// Closes contacts and reconnects components, in turns, since the one may undo the other.
void enforce_contacts(In_between_shape& shape)
{
  constexpr int most_turns = 4;
  for (int turn = 0; turn < most_turns; ++turn) {
    const Relaxation relaxation = relax_contacts(shape);
    if (turn > 0 && relaxation == Relaxation::NOTHING_TO_DO) return;
    place_unmatched_parts(shape);
    if (!reconnect_components(shape) || relaxation == Relaxation::OPEN) return;
  }
}

/// Lifts the shape out of the ground, or puts it there if no part of it is to stand.
void put_on_ground(In_between_shape& shape)
{
  double low = std::numeric_limits<double>::infinity();
  bool stands = false;
  for (std::size_t part = 0; part < shape.number_of_parts(); ++part) {
    if (!shape.is_there(part)) continue;
    low = std::min(low, shape.lowest(part));
    stands = stands || shape.part(part).stands;
  }
  const double rise = stands ? std::max(0., shape.ground() - low) : shape.ground() - low;
  for (std::size_t part = 0; part < shape.number_of_parts(); ++part)
    shape.apply({Point::Zero(), Point(0, rise, 0), Eigen::Matrix3d::Zero()}, part);
}

} // namespace

In_between_shape in_between_shape(const Blend_structure& blend, const Task_times& times, double t)
{
  In_between_shape shape(blend, times, t);
  symmetrise(shape);
  enforce_contacts(shape);
  put_on_ground(shape);
  return shape;
}

} // namespace CGAL::Shape_correspondence::internal

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/Exchanged_bodies.h"

#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

struct Blend_stage;

/// Where a chain touches what it is held by: a matched part, or a body that is placed before.
struct Anchor
{
  Point at;
  std::size_t body = Exchanged_bodies::none;
  std::size_t part = 0;              ///< if it is no body, the matched part
  Point coordinates = Point::Zero(); ///< of that, there
};

/// Unmatched parts of an end that hold together: they go with what they touch, and come or go as one. What a body has
/// at an end is a chain.
struct Unmatched_chain
{
  int end = 0;
  std::size_t body = Exchanged_bodies::none; ///< if it is one
  std::vector<std::size_t> parts;            ///< of the blend
  std::vector<Anchor> anchors;
  contacts::Box box;
  contacts::Box other_box;    ///< of a body, at the other end
  Point root = Point::Zero(); ///< what it shrinks to, and grows from

  bool is_body() const { return body != Exchanged_bodies::none; }
  bool stands() const { return box.min().y() <= Blend_part::on_ground; }
  /// Points of it when a share of it remains, in [0, 1].
  Points shrunk(const Points& points, double remaining) const
  {
    return (remaining * (points.colwise() - root)).colwise() + root;
  }
};

/// The chains of the parts that are not matched: first, in order, of each body that of the source and that of the
/// target, then the others.
std::vector<Unmatched_chain> unmatched_chains(const Blend_stage& stage, const Blend_structure& blend,
                                              const Exchanged_bodies& bodies);

} // namespace CGAL::Shape_correspondence::internal

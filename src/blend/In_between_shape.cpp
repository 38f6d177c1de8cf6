// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/In_between_shape.h"

#include "blend/ease.h"

#include <algorithm>
#include <utility>

namespace CGAL::Shape_correspondence::internal {

In_between_shape::In_between_shape(const Blend_structure& blend, const Task_times& times, double t)
    : blend_(blend),
      t_(eased(t)),
      points_(blend.parts.size()),
      surface_(blend.parts.size(), -1),
      others_(blend.parts.size()),
      has_other_(blend.parts.size(), 0),
      remaining_(blend.parts.size(), 1),
      trees_(blend.parts.size()),
      has_moved_(blend.parts.size(), 1),
      stretches_(blend.parts.size())
{
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const Blend_part& part = blend.parts[i];
    const double own = eased((t - times[i][0]) / (times[i][1] - times[i][0]));
    if (part.morph) {
      surface_[i] = part.morph->surface(own);
      for (int surface : {0, 1})
        if (!part.is_exchange() || surface == surface_[i] || part.holds[std::size_t(surface)])
          points_[i][std::size_t(surface)] = part.points(surface, own);
      if (!part.is_exchange()) continue;
      const int other = 1 - surface_[i];
      const double there = Part_morph::remaining(other, own);
      has_other_[i] = there > nothing;
      others_[i] = part.points(other, own, there);
    } else {
      remaining_[i] = part.end() == 0 ? 1 - own : own;
    }
  }
}

void In_between_shape::set_unmatched(std::size_t part, Points points)
{
  points_[part][0] = std::move(points);
  has_moved_[part] = 1;
  stretches_[part] = {};
  if (remaining_[part] > nothing) surface_[part] = 0;
}

Points& In_between_shape::moving_points(std::size_t part)
{
  has_moved_[part] = 1;
  return points_[part][std::size_t(surface_[part])];
}

const In_between_shape::Tree& In_between_shape::tree(std::size_t part)
{
  std::optional<Tree>& tree = trees_[part];
  if (!tree) tree = blend_.parts[part].trees[std::size_t(surface_[part])];
  if (!has_moved_[part]) return *tree;
  const Eigen::Matrix3Xi& triangles = blend_.parts[part].triangles(surface_[part]);
  tree->move([&](std::size_t t) { return triangle_of(points(part), triangles, t); });
  has_moved_[part] = 0;
  return *tree;
}

const In_between_shape::Trees& In_between_shape::trees()
{
  for (std::size_t part = 0; part < trees_.size(); ++part)
    if (is_there(part)) tree(part);
  return trees_;
}

void In_between_shape::drop_trees()
{
  trees_.assign(trees_.size(), std::nullopt);
  has_moved_.assign(trees_.size(), 1);
}

void In_between_shape::apply(const Affine_motion& motion, std::size_t part)
{
  if (motion.is_none()) return;
  has_moved_[part] = 1;
  for (Points& surface : points_[part])
    motion.apply(surface);
  motion.apply(others_[part]);
}

double In_between_shape::needed_rise(std::size_t part) const
{
  const Blend_part& standing = blend_.parts[part];
  if (!standing.stands) return std::max(0., ground() - lowest(part));
  const double level = (1 - t_) * standing.foot[0] + t_ * standing.foot[1];
  return ground() + level - lowest(part);
}

void In_between_shape::add_disconnection(double gap) { widest_disconnection_ = std::max(widest_disconnection_, gap); }

} // namespace CGAL::Shape_correspondence::internal

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/In_between_shape.h"

#include <algorithm>
#include <cmath>

namespace CGAL::Shape_correspondence::internal {
namespace {

constexpr double no_extent = 1e-6; // of the height: what is narrower is not stretched

/// The map that stretches along the axes from one box to another; extents that are none are moved only.
Eigen::Affine3d box_map(const contacts::Box& from, const contacts::Box& to)
{
  Eigen::Affine3d result = Eigen::Affine3d::Identity();
  for (int axis = 0; axis < 3; ++axis)
    if (from.sizes()[axis] > no_extent) result.linear()(axis, axis) = to.sizes()[axis] / from.sizes()[axis];
  result.translation() = to.center() - result.linear() * from.center();
  return result;
}

} // namespace

In_between_shape::In_between_shape(const Blend_structure& blend, const std::vector<Blend_task>& tasks, double t)
    : blend_(blend), t_(t), points_(blend.parts.size()), surface_(blend.parts.size(), -1)
{
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (!part(i).is_matched()) continue;
    surface_[i] = part(i).morph->surface(t);
    points_[i] = part(i).points(surface_[i], t);
  }
  place_chains(tasks);
  fill_the_height();
}

contacts::Box In_between_shape::due_box() const
{
  const auto& [from, to] = blend_.boxes;
  return {(1 - t_) * from.min() + t_ * to.min(), (1 - t_) * from.max() + t_ * to.max()};
}

Points In_between_shape::points(std::size_t number, int surface) const
{
  if (surface == surface_[number] || !part(number).is_matched()) return points_[number];
  return stretch_ * part(number).points(surface, t_);
}

In_between_shape::Trees In_between_shape::trees() const
{
  Trees result(points_.size());
  for (std::size_t i = 0; i < result.size(); ++i) {
    if (!is_there(i)) continue;
    result[i] = part(i).trees[std::size_t(surface_[i])];
    const Eigen::Matrix3Xi& triangles = part(i).triangles(surface_[i]);
    result[i]->move([&](std::size_t t) { return triangle_of(points(i), triangles, t); });
  }
  return result;
}

/// Places unmatched parts, as much of them as remains, where space moves.
void In_between_shape::place_chains(const std::vector<Blend_task>& tasks)
{
  std::array<Points, 2> ways; // of the nodes of the warps, by end
  for (int end : {0, 1}) {
    const auto& warp = blend_.warps[std::size_t(end)];
    if (!warp) continue;
    std::vector<Points> surfaces = points_; // of the end, where they are
    for (std::size_t i = 0; i < surfaces.size(); ++i)
      if (part(i).is_matched() && surface_[i] != end) surfaces[i] = part(i).points(end, t_);
    ways[std::size_t(end)] = warp->ways(blend_.parts, surfaces, t_);
  }
  for (const Unmatched_chain& chain : blend_.chains) {
    const auto end = std::size_t(chain.end);
    for (std::size_t number : chain.parts) {
      const Blend_task& task = tasks[number];
      const double done = std::clamp((t_ - task.begin) / (task.end - task.begin), 0., 1.),
                   remaining = end == 0 ? 1 - done : done;
      if (remaining > nothing) surface_[number] = 0;
      const Points shrunk = chain.shrunk(part(number).mesh.points, remaining);
      points_[number] = blend_.warps[end]->moved(shrunk, ways[end]);
    }
  }
}

/// Stretches the whole so that it stands and is as high as is due.
void In_between_shape::fill_the_height()
{
  constexpr double most = 2; // times as high: there is less only while half of the old and half of the new is there
  contacts::Box all;
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (is_there(i)) all.extend(box_of(points_[i]));
  if (all.isEmpty()) return;
  contacts::Box due = all;
  due.min().y() = 0;
  due.max().y() = std::min(due_box().max().y(), most * all.sizes().y());
  stretch_ = box_map(all, due);
  for (Points& points : points_)
    points = stretch_ * points;
}

} // namespace CGAL::Shape_correspondence::internal

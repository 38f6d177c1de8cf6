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

/// Stretches what is in a box along y so that it begins at a level, while another height stays; what would be stretched
/// too much moves as a whole.
Eigen::Affine3d grounded(const contacts::Box& box, double stays, double level, double most)
{
  Eigen::Affine3d result = Eigen::Affine3d::Identity();
  const double low = box.min().y(), stretch = stays - low > no_extent ? (stays - level) / (stays - low) : 0;
  if (stretch > 1 / most && stretch < most) {
    result.linear()(1, 1) = stretch;
    result.translation().y() = stays - stretch * stays;
  } else {
    result.translation().y() = level - low;
  }
  return result;
}

/// How a chain moves and is stretched along the axes so that points of it come to where they are due, on average, and
/// as nearly as it may be stretched: by more where the points are far apart.
/// \param rest by how much it is stretched if the points do not tell
Eigen::Affine3d motion_between(const Points& from, const Points& to, const contacts::Box& box, const Point& rest)
{
  constexpr double stiffness = 0.02; // against 1, the weight of a point that is as far as the chain is large
  constexpr double some = 1e-6;      // of the height
  constexpr double far = 0.5, most = 1.4, most_between = 2.5; // far: of the extent
  const double stiff = stiffness * std::pow(box.diagonal().norm() / 2 + some, 2);
  const Point middle = from.rowwise().mean(), due = to.rowwise().mean();
  Eigen::Affine3d result = Eigen::Affine3d::Identity();
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::ArrayXd at = from.row(axis).array() - middle[axis], wanted = to.row(axis).array() - due[axis];
    const double stretch = ((at * wanted).sum() + stiff * rest[axis]) / (at.square().sum() + stiff);
    const double limit = at.maxCoeff() - at.minCoeff() > far * box.sizes()[axis] ? most_between : most;
    result.linear()(axis, axis) = std::clamp(stretch, 1 / limit, limit);
  }
  result.translation() = due - result.linear() * middle;
  return result;
}

Points corners(const contacts::Box& box)
{
  Points result(3, 2);
  result << box.min(), box.max();
  return result;
}

} // namespace

In_between_shape::In_between_shape(const Blend_structure& blend, const Task_times& times, double t)
    : blend_(blend),
      t_(t),
      points_(blend.parts.size()),
      shifts_(blend.parts.size(), Point::Zero()),
      surface_(blend.parts.size(), -1)
{
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (!part(i).is_matched()) continue;
    surface_[i] = part(i).morph->surface(t);
    points_[i] = part(i).points(surface_[i], t);
  }
  Trees matched = trees();
  close_gaps(matched);
  for (const Unmatched_chain& chain : blend.chains)
    place(chain, times, matched);
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
  return stretch_ * (part(number).points(surface, t_).colwise() + shifts_[number]);
}

/// Moves matched parts so that they hold on to the largest of those that they touch at both ends.
void In_between_shape::close_gaps(Trees& trees)
{
  for (const Touch& hold : blend_.holds) {
    const std::size_t moved = hold.parts[0], carrier = hold.parts[1];
    contacts::Closest_pair closest;
    trees[moved]->improve_closest(*trees[carrier], closest);
    const double gap = std::sqrt(closest.squared), excess = gap - hold.allowed_gap(t_);
    if (excess <= 0) continue;
    shifts_[moved] = excess / gap * (closest.second - closest.first);
    if (blend_.is_symmetric && is_central(trees[moved]->box())) shifts_[moved].x() = 0;
    points_[moved].colwise() += shifts_[moved];
    const Eigen::Matrix3Xi& triangles = part(moved).triangles(surface_[moved]);
    trees[moved]->move([&](std::size_t t) { return triangle_of(points_[moved], triangles, t); });
  }
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

/// Places unmatched parts so that they hold on to what they touch, and stand. Where that leaves it open, they become
/// wider or narrower as the whole does; what touches nothing goes with the box around the whole.
void In_between_shape::place(const Unmatched_chain& chain, const Task_times& times, const Trees& matched)
{
  constexpr double most = 5; // that it is stretched to stand
  const Eigen::Affine3d whole = box_map(blend_.boxes[std::size_t(chain.end)], due_box());
  const auto held = Eigen::Index(std::max<std::size_t>(chain.anchors.size(), 1));
  Points from(3, held), to(3, held);
  from.col(0) = chain.root;
  to.col(0) = whole * chain.root;
  for (std::size_t i = 0; i < chain.anchors.size(); ++i) {
    const Anchor& anchor = chain.anchors[i];
    std::size_t triangle = 0;
    from.col(Eigen::Index(i)) = anchor.at;
    const Point due = part(anchor.part).morph->place(anchor.coordinates, t_) + shifts_[anchor.part];
    to.col(Eigen::Index(i)) = matched[anchor.part]->nearest(due, triangle);
  }
  Eigen::Affine3d map = motion_between(from, to, chain.box, whole.linear().diagonal());
  if (blend_.is_symmetric && is_central(chain.box)) map.translation().x() = 0;
  const auto placed = [&] { return box_of(map * corners(chain.box)); };
  if (chain.stands() || placed().min().y() < 0)
    map = grounded(placed(), (map * chain.root).y(), chain.stands() ? chain.box.min().y() : 0, most) * map;
  const auto [begin, end] = times[chain.parts[0]];
  const double done = std::clamp((t_ - begin) / (end - begin), 0., 1.), remaining = chain.end == 0 ? 1 - done : done;
  for (std::size_t i : chain.parts) {
    if (remaining > nothing) surface_[i] = 0;
    points_[i] = map * chain.shrunk(part(i).mesh.points, remaining);
  }
}

/// Stretches the whole so that it stands and is as high as is due.
void In_between_shape::fill_the_height()
{
  contacts::Box all;
  bool is_matched = false;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (is_there(i)) all.extend(box_of(points_[i]));
    is_matched = is_matched || part(i).is_matched();
  }
  if (!is_matched) return; // else at any time something has its full size
  contacts::Box due = all;
  due.min().y() = 0;
  due.max().y() = due_box().max().y();
  stretch_ = box_map(all, due);
  for (Points& points : points_)
    points = stretch_ * points;
}

} // namespace CGAL::Shape_correspondence::internal

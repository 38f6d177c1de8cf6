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

// Of unmatched parts
constexpr double least_stretch = 0.7, most_stretch = 1.4;

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

/// How a body moves and is stretched along the axes so that points of it come to where they are due, on average, and as
/// nearly as it may be stretched.
/// \param rest by how much it is stretched if the points do not tell
Eigen::Affine3d motion_between(const Points& from, const Points& to, double size, const Point& rest)
{
  constexpr double stiffness = 0.02; // against 1, the weight of a point that is as far as the body is large
  constexpr double some = 1e-6;      // of the height
  const Point middle = from.rowwise().mean(), due = to.rowwise().mean();
  Eigen::Affine3d result = Eigen::Affine3d::Identity();
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::ArrayXd at = from.row(axis).array() - middle[axis], wanted = to.row(axis).array() - due[axis];
    const double stiff = stiffness * std::pow(size + some, 2),
                 stretch = ((at * wanted).sum() + stiff * rest[axis]) / (at.square().sum() + stiff);
    result.linear()(axis, axis) = std::clamp(stretch, least_stretch, most_stretch);
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
    : blend_(blend), t_(t), points_(blend.parts.size()), surface_(blend.parts.size(), -1)
{
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (!part(i).morph) continue;
    surface_[i] = part(i).morph->surface(t);
    points_[i] = part(i).points(surface_[i], t);
  }
  const Trees matched = trees();
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
  if (surface == surface_[number] || !part(number).morph) return points_[number];
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
    const Point due = part(anchor.carrier).morph->place(anchor.coordinates, t_);
    std::size_t triangle = 0;
    from.col(Eigen::Index(i)) = anchor.at;
    to.col(Eigen::Index(i)) = matched[anchor.carrier]->nearest(due, triangle);
  }
  Eigen::Affine3d map = motion_between(from, to, chain.box.diagonal().norm() / 2, whole.linear().diagonal());
  const auto body = [&] { return box_of(map * corners(chain.box)); };
  if (chain.stands() || body().min().y() < 0)
    map = grounded(body(), (map * chain.root).y(), chain.stands() ? chain.box.min().y() : 0, most) * map;
  for (std::size_t i : chain.parts) {
    const double done = std::clamp((t_ - times[i][0]) / (times[i][1] - times[i][0]), 0., 1.);
    const double remaining = chain.end == 0 ? 1 - done : done;
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
    is_matched = is_matched || part(i).morph;
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

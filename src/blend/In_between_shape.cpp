// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/In_between_shape.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

contacts::Box between(const contacts::Box& from, const contacts::Box& to, double share)
{
  return {(1 - share) * from.min() + share * to.min(), (1 - share) * from.max() + share * to.max()};
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

In_between_shape::In_between_shape(const Blend_structure& blend, const Blend_layout& layout, double t)
    : blend_(blend), layout_(layout), t_(t), points_(blend.parts.size()), surface_(blend.parts.size(), -1)
{
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (!part(i).is_matched()) continue;
    surface_[i] = part(i).morph->surface(t);
    points_[i] = part(i).points(surface_[i], t);
  }
  const Trees matched = trees();
  for (const Unmatched_chain& chain : layout.chains)
    place(chain, matched);
  fill_the_height();
}

contacts::Box In_between_shape::due_box() const { return between(blend_.boxes[0], blend_.boxes[1], t_); }

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

/// How much of a chain's task is done, from 0 to 1.
double In_between_shape::done(const Unmatched_chain& chain) const
{
  const auto [begin, end] = layout_.times[chain.parts[0]];
  return std::clamp((t_ - begin) / (end - begin), 0., 1.);
}

/// How a chain moves if nothing holds it: with the box around its body, or around the whole.
Eigen::Affine3d In_between_shape::natural_motion(const Unmatched_chain& chain) const
{
  if (!chain.is_body()) return box_map(blend_.boxes[std::size_t(chain.end)], due_box());
  return box_map(chain.box, between(chain.box, chain.other_box, chain.end == 0 ? t_ : 1 - t_));
}

/// Where a chain is due to be held: on the matched part, or on the body, which is the one of its end, and then the one
/// that is exchanged for it.
Point In_between_shape::held_at(const Unmatched_chain& chain, const Anchor& anchor, const Trees& matched) const
{
  std::size_t triangle = 0;
  if (anchor.body == Exchanged_bodies::none)
    return matched[anchor.part]->nearest(part(anchor.part).morph->place(anchor.coordinates, t_), triangle);
  const auto own = std::size_t(chain.end);
  const std::size_t carrier = 2 * anchor.body; // chains of bodies come in pairs
  const Unmatched_chain& other = layout_.chains[carrier + 1 - own];
  const Eigen::Affine3d& motion = motions_[carrier + 1 - own];
  const Point due = motions_[carrier + own] * anchor.at;
  Point nearest = due;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i : other.parts) {
    const Point near = motion * part(i).trees[0].nearest(motion.inverse() * due, triangle);
    const double distance = (near - due).norm();
    if (distance < least) least = distance, nearest = near;
  }
  const double exchanged = own == 0 ? done(other) : 1 - done(other);
  return (1 - exchanged) * due + exchanged * nearest;
}

/// Places unmatched parts so that they hold on to what they touch, and stand. Where that leaves it open, they become
/// wider or narrower as their natural motion is.
void In_between_shape::place(const Unmatched_chain& chain, const Trees& matched)
{
  constexpr double most = 5; // that it is stretched to stand
  const Eigen::Affine3d natural = natural_motion(chain);
  const auto held = Eigen::Index(std::max<std::size_t>(chain.anchors.size(), 1));
  Points from(3, held), to(3, held);
  from.col(0) = chain.root;
  to.col(0) = natural * chain.root;
  for (std::size_t i = 0; i < chain.anchors.size(); ++i) {
    from.col(Eigen::Index(i)) = chain.anchors[i].at;
    to.col(Eigen::Index(i)) = held_at(chain, chain.anchors[i], matched);
  }
  Eigen::Affine3d map = motion_between(from, to, chain.box.diagonal().norm() / 2, natural.linear().diagonal());
  const auto body = [&] { return box_of(map * corners(chain.box)); };
  if (chain.stands() || body().min().y() < 0)
    map = grounded(body(), (map * chain.root).y(), chain.stands() ? chain.box.min().y() : 0, most) * map;
  motions_.push_back(map);
  const double remaining = chain.end == 0 ? 1 - done(chain) : done(chain);
  for (std::size_t i : chain.parts) {
    if (remaining > nothing) surface_[i] = 0;
    points_[i] = map * chain.shrunk(part(i).mesh.points, remaining);
  }
}

/// Stretches the whole so that it stands and is as high as is due.
void In_between_shape::fill_the_height()
{
  contacts::Box all;
  bool is_whole = false; // else nothing may have its full size
  const auto& chains = layout_.chains;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (is_there(i)) all.extend(box_of(points_[i]));
    is_whole = is_whole || part(i).is_matched();
  }
  for (std::size_t i = 0; i < chains.size() && chains[i].is_body(); i += 2) { // what is exchanged, as if it were whole
    const contacts::Box from = box_of(motions_[i] * corners(chains[i].box)),
                        to = box_of(motions_[i + 1] * corners(chains[i + 1].box));
    all.extend(between(from, to, done(chains[i])));
    is_whole = true;
  }
  if (!is_whole) return;
  contacts::Box due = all;
  due.min().y() = 0;
  due.max().y() = due_box().max().y();
  stretch_ = box_map(all, due);
  for (Points& points : points_)
    points = stretch_ * points;
}

} // namespace CGAL::Shape_correspondence::internal

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/In_between_shape.h"

#include <algorithm>

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

contacts::Box between(const contacts::Box& a, const contacts::Box& b, double t)
{
  return {(1 - t) * a.min() + t * b.min(), (1 - t) * a.max() + t * b.max()};
}

// Of bodies that close contacts
constexpr double least_stretch = 0.7, most_stretch = 1.4;
constexpr double least_size = 1e-3; // of the height

double size_of(const contacts::Box& box) { return std::max(box.diagonal().norm() / 2, least_size); }

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
/// nearly as little stretch allows.
Eigen::Affine3d motion_between(const Points& from, const Points& to, const Eigen::VectorXd& weights, double size)
{
  constexpr double stiffness = 0.02; // against 1, the weight of a point that is as far as the body is large
  const Point middle = from * weights / weights.sum(), due = to * weights / weights.sum();
  Eigen::Affine3d result = Eigen::Affine3d::Identity();
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::ArrayXd at = from.row(axis).array() - middle[axis], wanted = to.row(axis).array() - due[axis];
    const double rest = stiffness * size * size,
                 stretch = ((weights.array() * at * wanted).sum() + rest) / ((weights.array() * at * at).sum() + rest);
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
    : blend_(blend),
      progress_(blend.parts.size(), 0),
      remaining_(blend.parts.size(), 1),
      points_(blend.parts.size()),
      surface_(blend.parts.size(), -1),
      placements_(blend.parts.size(), Eigen::Affine3d::Identity())
{
  set_progress(times, t);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const Blend_part& part = blend.parts[i];
    if (part.morph) {
      surface_[i] = part.morph->surface(progress_[i]);
      points_[i] = part.points(surface_[i], progress_[i]);
    } else if (remaining_[i] > nothing) {
      surface_[i] = 0;
    }
  }
  close_contacts();
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (part(i).morph) put_on_ground(i);
  for (const Unmatched_chain& chain : blend.chains)
    place(chain);
  fill_the_height();
}

/// The whole is as far as matched parts are on average, by their sizes.
void In_between_shape::set_progress(const Task_times& times, double t)
{
  double sum = 0, sizes = 0;
  for (std::size_t i = 0; i < progress_.size(); ++i) {
    const Blend_part& part = blend_.parts[i];
    progress_[i] = std::clamp((t - times[i][0]) / (times[i][1] - times[i][0]), 0., 1.);
    if (part.morph) {
      sum += part.size * progress_[i];
      sizes += part.size;
    } else {
      remaining_[i] = part.end() == 0 ? 1 - progress_[i] : progress_[i];
    }
  }
  whole_ = sizes > 0 ? sum / sizes : t;
}

contacts::Box In_between_shape::due_box() const { return between(blend_.boxes[0], blend_.boxes[1], whole_); }

Points In_between_shape::points(std::size_t part, int surface) const
{
  const Blend_part& own = blend_.parts[part];
  if (surface == surface_[part] || !own.morph) return points_[part];
  return placements_[part] * own.points(surface, progress_[part]);
}

In_between_shape::Trees In_between_shape::trees() const
{
  Trees result(points_.size());
  for (std::size_t part = 0; part < result.size(); ++part) {
    if (!is_there(part)) continue;
    result[part] = blend_.parts[part].trees[std::size_t(surface_[part])];
    const Eigen::Matrix3Xi& triangles = blend_.parts[part].triangles(surface_[part]);
    result[part]->move([&](std::size_t t) { return triangle_of(points(part), triangles, t); });
  }
  return result;
}

void In_between_shape::place(std::size_t part, const Eigen::Affine3d& map)
{
  placements_[part] = map * placements_[part];
  if (points_[part].cols() > 0) points_[part] = map * points_[part];
}

/// Moves and stretches matched parts so that their contacts hold.
void In_between_shape::close_contacts()
{
  std::vector<Moving_body> bodies(points_.size());
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (part(i).morph) bodies[i] = {box_of(points_[i]).center(), size_of(box_of(points_[i]))};
  Box_motion_solver solver(bodies);
  for (const Kept_contact& contact : blend_.contacts) {
    const auto [a, b] = contact.parts;
    for (const std::array<Carried_point, 2>& at : contact.points)
      solver.add_contact(a, part(a).place(at[0], progress_[a]), b, part(b).place(at[1], progress_[b]), 1);
  }
  const std::vector<Box_motion> motions = solver.solve(least_stretch, most_stretch);
  for (std::size_t i = 0; i < motions.size(); ++i) {
    if (!part(i).morph) continue;
    const bool has_image = blend_.is_symmetric && part(i).has_image();
    place(i, (has_image ? motions[i].symmetrised(motions[part(i).image]) : motions[i]).map());
  }
}

/// Stretches a matched part that stands to its height above the ground, and one that is in the ground up out of it;
/// what is highest stays.
void In_between_shape::put_on_ground(std::size_t part)
{
  constexpr double most = 2; // that it is stretched
  const Blend_part& own = blend_.parts[part];
  const contacts::Box box = box_of(points_[part]);
  if (own.stands || box.min().y() < 0)
    place(part, grounded(box, box.max().y(), own.stands ? own.due_foot(progress_[part]) : 0, most));
}

/// Places unmatched parts so that they hold on to what they touch, and stand; what touches nothing goes with the box
/// around the whole.
void In_between_shape::place(const Unmatched_chain& chain)
{
  constexpr double most = 5; // that it is stretched to stand
  const Point due = box_map(blend_.boxes[std::size_t(chain.end)], due_box()) * chain.root;
  Eigen::Affine3d map(Eigen::Translation3d(due - chain.root));
  const auto touched = Eigen::Index(chain.anchors.size());
  Points from(3, touched), to(3, touched);
  Eigen::VectorXd weights(touched);
  for (Eigen::Index i = 0; i < touched; ++i) {
    const Anchor& anchor = chain.anchors[std::size_t(i)];
    const Blend_part& carrier = part(anchor.carrier);
    from.col(i) = map * anchor.at;
    to.col(i) = placements_[anchor.carrier] * carrier.place(anchor.carried, progress_[anchor.carrier]);
    weights[i] = std::min(1., std::max(carrier.size / 2, least_size) / size_of(chain.box)); // the small yields
  }
  const auto body = [&] { return box_of(map * corners(chain.box)); };
  if (touched > 0) map = motion_between(from, to, weights, size_of(body())) * map;
  if (chain.stands() || body().min().y() < 0)
    map = grounded(body(), (map * chain.root).y(), chain.stands() ? chain.box.min().y() : 0, most) * map;
  for (std::size_t i : chain.parts)
    points_[i] = map * chain.shrunk(part(i).mesh.points, remaining_[i]);
}

/// Stretches the whole so that it is as high as is due.
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
  all.min().y() = std::min(0., all.min().y());
  for (std::size_t i = 0; i < points_.size(); ++i)
    place(i, box_map(all, due));
}

} // namespace CGAL::Shape_correspondence::internal

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/In_between_shape.h"

#include <algorithm>
#include <memory>

namespace CGAL::Shape_correspondence::internal {
namespace {

constexpr double no_extent = 1e-6; // of the height: what is narrower is not stretched
constexpr double little = 0.25;    // what remains of a part from where on it counts less and less

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
      points_[i] = part.points(0, 0);
    }
  }
  close_contacts(true);
  ride_carriers();
  close_contacts(false);
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (is_there(i)) put_on_ground(i);
  draw_back();
  fill_the_box();
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
  present_ = {present_box(0), present_box(1)};
}

contacts::Box In_between_shape::due_box() const { return between(blend_.boxes[0], blend_.boxes[1], whole_); }

/// The box of an end around what there is of its parts, as high as the whole: nothing becomes wide for what is not
/// there yet, or any more. Parts that come or go count as far as there is something of them, so that nothing jumps.
contacts::Box In_between_shape::present_box(int end) const
{
  const auto box = [&](std::size_t part) -> const contacts::Box& {
    return blend_.parts[part].trees[std::size_t(blend_.parts[part].end_surface(end))].box();
  };
  contacts::Box matched;
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (blend_.parts[i].morph) matched.extend(box(i));
  if (matched.isEmpty()) return blend_.boxes[std::size_t(end)];
  contacts::Box result = matched;
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (!blend_.parts[i].morph && blend_.parts[i].end() == end)
      result.extend(between(matched, matched.merged(box(i)), std::min(1., remaining_[i] / little)));
  result.min().y() = blend_.boxes[std::size_t(end)].min().y();
  result.max().y() = blend_.boxes[std::size_t(end)].max().y();
  return result;
}

contacts::Box In_between_shape::due_of_present() const { return between(present_[0], present_[1], whole_); }

Points In_between_shape::points(std::size_t part, int surface) const
{
  const Blend_part& own = blend_.parts[part];
  if (surface == surface_[part]) return points_[part];
  return placements_[part] * own.points(surface, progress_[part], remaining_[part]);
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

/// Stretches unmatched parts as the whole, and moves them to where what carries them has taken their roots.
void In_between_shape::ride_carriers()
{
  constexpr double least_stretch = 0.5, most_stretch = 2;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const Blend_part& part = blend_.parts[i];
    if (!part.retreat) continue;
    const auto end = std::size_t(part.end());
    const Eigen::Affine3d whole = box_map(present_[end], due_of_present());
    Eigen::Affine3d map(whole.linear().diagonal().cwiseMax(least_stretch).cwiseMin(most_stretch).asDiagonal());
    Point way = Point::Zero();
    for (const Root& root : part.roots)
      way += (root.carriers.empty() ? whole : carrier_map(root.carriers, end)) * root.at - map * root.at;
    map.translation() += way / double(part.roots.size());
    place(i, map);
  }
}

/// How a part, of which these are all pieces, has moved and been stretched.
Eigen::Affine3d In_between_shape::carrier_map(const std::vector<std::size_t>& pieces, std::size_t end) const
{
  if (blend_.parts[pieces[0]].retreat) return placements_[pieces[0]];
  contacts::Box from, to;
  for (std::size_t piece : pieces) {
    from.extend(blend_.parts[piece].trees[std::size_t(blend_.parts[piece].end_surface(int(end)))].box());
    to.extend(box_of(points_[piece]));
  }
  return box_map(from, to);
}

/// First those of matched parts with each other; then unmatched parts follow, which do not pull at matched ones.
void In_between_shape::close_contacts(bool of_matched)
{
  constexpr double least_stretch = 0.7, most_stretch = 1.4, least_size = 1e-3;
  const auto moves = [&](std::size_t i) { return is_there(i) && bool(part(i).morph) == of_matched; };
  std::vector<Moving_body> bodies(points_.size());
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (!is_there(i)) continue;
    const contacts::Box box = box_of(points_[i]);
    bodies[i] = {box.center(), std::max(box.diagonal().norm() / 2, least_size), !moves(i)};
  }
  Box_motion_solver solver(bodies);
  for (const Kept_contact& contact : blend_.contacts) {
    const auto [a, b] = contact.parts;
    if (of_matched ? !moves(a) || !moves(b) : !is_there(a) || !is_there(b) || !(moves(a) || moves(b))) continue;
    const auto at = [&](std::size_t part, const Carried_point& p) -> Point {
      return placements_[part] * blend_.parts[part].place(p, progress_[part], 1);
    };
    for (const Contact_points& at_one : contact.points)
      solver.add_contact(a, at(a, at_one.points[0]) + at_one.due_offset(whole_), b, at(b, at_one.points[1]), 1);
  }
  const std::vector<Box_motion> motions = solver.solve(least_stretch, most_stretch);
  for (std::size_t i = 0; i < motions.size(); ++i) {
    if (!moves(i)) continue;
    const std::size_t image = blend_.parts[i].image;
    const bool has_image = blend_.is_symmetric && image != Blend_task::no_part && is_there(image);
    place(i, (has_image ? motions[i].symmetrised(motions[image]) : motions[i]).map());
  }
}

/// Stretches a part that stands to its height above the ground, and one that is in the ground up out of it; what is
/// highest stays. What would be stretched too much moves as a whole, unless it hangs.
void In_between_shape::put_on_ground(std::size_t part)
{
  constexpr double most_stretch_standing = 2, most_stretch_hanging = 5;
  const Blend_part& own = blend_.parts[part];
  const bool hangs = own.retreat && !own.roots[0].carriers.empty();
  const double most_stretch = hangs ? most_stretch_hanging : most_stretch_standing, least_stretch = 1 / most_stretch;
  const double low = points_[part].row(1).minCoeff(), high = points_[part].row(1).maxCoeff();
  const double level = own.stands ? own.due_foot(progress_[part]) : 0;
  if (!own.stands && low >= 0) return;
  Eigen::Affine3d map = Eigen::Affine3d::Identity();
  const double stretch = high - low > no_extent ? (high - level) / (high - low) : 0;
  if (stretch > least_stretch && stretch < most_stretch) {
    map.linear()(1, 1) = stretch;
    map.translation().y() = high - stretch * high;
  } else {
    map.translation().y() = level - low;
  }
  place(part, map);
}

/// Draws unmatched parts, which were placed as wholes, back to their roots, which go with those of what carries them.
void In_between_shape::draw_back()
{
  const std::vector<Eigen::Affine3d> as_wholes = placements_;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const Blend_part& part = blend_.parts[i];
    if (!part.retreat) continue;
    Point shift = Point::Zero();
    const Point root = as_wholes[i] * part.retreat->root();
    double count = 0;
    for (const Root& at : part.roots)
      for (std::size_t carrier : at.carriers) {
        ++count;
        if (const std::shared_ptr<const Retreating_part>& by = blend_.parts[carrier].retreat)
          shift += placements_[carrier] * by->place(as_wholes[carrier].inverse() * root, remaining_[carrier]) - root;
      }
    if (count > 0) shift /= count;
    placements_[i].pretranslate(shift);
    if (is_there(i)) points_[i] = placements_[i] * part.points(0, 0, remaining_[i]);
  }
}

/// Stretches the whole so that it fills the box that is due. Unmatched parts count as far as there is something of
/// them, so that nothing jumps when one goes.
void In_between_shape::fill_the_box()
{
  contacts::Box matched;
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (blend_.parts[i].morph) matched.extend(box_of(points_[i]));
  if (matched.isEmpty()) return;
  contacts::Box all = matched;
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (is_there(i) && !blend_.parts[i].morph) {
      const double share = std::min(1., remaining_[i] / little);
      const contacts::Box with = matched.merged(box_of(points_[i]));
      all.extend(between(matched, with, share));
    }
  all.min().y() = std::min(0., all.min().y());
  if (blend_.is_symmetric) {
    const double half = std::max(-all.min().x(), all.max().x());
    all.min().x() = -half;
    all.max().x() = half;
  }
  contacts::Box due = due_of_present();
  if (blend_.is_symmetric) {
    const double half = std::max(-due.min().x(), due.max().x());
    due.min().x() = -half;
    due.max().x() = half;
  }
  const Eigen::Affine3d map = box_map(all, due);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    place(i, map);
    if (!is_there(i) || blend_.parts[i].morph) continue;
    const contacts::Box own = box_of(points_[i]); // what counts less may have been stretched beyond
    if (!due.contains(own) && due.intersects(own)) place(i, box_map(own, own.intersection(due)));
  }
}

} // namespace CGAL::Shape_correspondence::internal

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Affine_motion.h"
#include "blend/in_between_steps.h"
#include "blend/mirror_images.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::internal {
namespace {

/// The middle of the lowest points of a part.
Point foot(const In_between_shape& shape, std::size_t part)
{
  constexpr double level = 1e-3; // of the height, over the lowest one
  const Points& points = shape.points(part);
  const double low = shape.lowest(part);
  Point sum = Point::Zero();
  int count = 0;
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    if (points(1, i) <= low + level) sum += points.col(i), ++count;
  return sum / count;
}

/// Stretches a part that stands down to its place on the ground, and one that is in the ground up out of it; what is
/// highest stays. What is beyond half of its height, or beyond its bounds, the whole part moves.
void put_foot(In_between_shape& shape, std::size_t part)
{
  const double rise = shape.needed_rise(part);
  const double high = shape.points(part).row(1).maxCoeff(),
               height = std::max(high - shape.lowest(part), least_stretched_size);
  const double stretch = std::clamp(rise, -height / 2, height / 2);
  Affine_motion motion{Point(0, high, 0), Point(0, rise - stretch, 0), Eigen::Matrix3d::Zero()};
  motion.gradient(1, 1) = -stretch / height;
  shape.stretch(motion, part);
  shape.apply({Point::Zero(), Point(0, shape.needed_rise(part), 0), Eigen::Matrix3d::Zero()}, part);
}

class Contact_relaxation
{
public:
  explicit Contact_relaxation(In_between_shape& shape) : shape_(shape), nearest_(shape.blend().contacts.size()) {}

  /// Moves all parts once, if any contact is open or any foot is off its place. Returns by how much they are, all
  /// together, before.
  double improve()
  {
    Affine_motion_solver solver(bodies());
    const double open = add_contacts(solver) + add_feet(solver);
    if (open > 0) move(solver.solve());
    ++round_;
    return open;
  }

private:
  std::vector<Moving_body> bodies() const
  {
    constexpr double inertia = 0.01; // of a part as large as the shape is high, against a contact's 1
    std::vector<Moving_body> result(shape_.number_of_parts());
    for (std::size_t part = 0; part < result.size(); ++part) {
      if (!shape_.is_there(part)) continue;
      const contacts::Box box = box_of(shape_.points(part));
      const double size = std::max(box.diagonal().norm(), In_between_shape::least_stretched * shape_.part(part).size);
      result[part] = {box.center(), size, inertia * size, shape_.is_at_bound(part)};
    }
    return result;
  }

  /// Where a contact is closest: searched for every few rounds, and in between at the triangles where it was.
  contacts::Closest_pair closest_points(std::size_t contact, double enough)
  {
    constexpr int searched_every = 4;
    const auto [a, b] = shape_.blend().contacts[contact].parts;
    contacts::Triangle_pair& near = nearest_[contact];
    if (round_ % searched_every == 0) return shape_.tree(a).nearly_closest(shape_.tree(b), enough, near);
    contacts::Closest_pair result;
    contacts::improve_by_triangles(triangle(a, near.first), triangle(b, near.second), result);
    return result;
  }

  /// A triangle where it is now, by its number in the part's tree, which may be behind.
  contacts::Triangle triangle(std::size_t part, std::size_t in_tree) const
  {
    const Blend_part& moved = shape_.part(part);
    const int surface = shape_.surface(part);
    const std::size_t given = moved.trees[std::size_t(surface)]->given_number(in_tree);
    return triangle_of(shape_.points(part), moved.triangles(surface), given);
  }

  /// Returns by how much contacts are open.
  double add_contacts(Affine_motion_solver& solver)
  {
    constexpr double closed = In_between_shape::closed_gap;
    double open = 0;
    for (std::size_t i = 0; i < nearest_.size(); ++i) {
      const Contact_constraint& contact = shape_.blend().contacts[i];
      const auto [a, b] = contact.parts;
      const double allowed = contact.allowed_gap(shape_.time());
      const contacts::Closest_pair closest = closest_points(i, allowed + closed);
      const double gap = std::sqrt(closest.squared);
      if (gap + In_between_shape::widest_connected_gap < allowed) continue; // it holds nothing
      Point step = Point::Zero();
      if (gap > allowed + closed) {
        step = (gap - allowed) / gap * (closest.second - closest.first);
        open += gap - allowed;
      }
      solver.add_contact(a, closest.first, b, closest.second, step);
      const Blend_part &first = shape_.part(a), &second = shape_.part(b);
      if (first.has_image() && second.has_image())
        solver.add_contact(first.image, mirrored(closest.first), second.image, mirrored(closest.second),
                           mirrored(step));
    }
    return open;
  }

  /// Returns by how much feet are off their places.
  double add_feet(Affine_motion_solver& solver) const
  {
    double off = 0;
    for (std::size_t part = 0; part < shape_.number_of_parts(); ++part) {
      if (!shape_.is_there(part)) continue;
      const double rise = shape_.needed_rise(part);
      if (!shape_.part(part).stands && rise <= 0) continue;
      solver.add_rise(part, foot(shape_, part), rise);
      if (std::abs(rise) > In_between_shape::closed_gap) off += std::abs(rise);
    }
    return off;
  }

  void move(const std::vector<Affine_motion>& motions)
  {
    for (std::size_t part = 0; part < motions.size(); ++part) {
      const Blend_part& moved = shape_.part(part);
      shape_.stretch(moved.has_image() ? motions[part].symmetrised(motions[moved.image]) : motions[part], part);
      if (!shape_.is_there(part)) continue;
      put_foot(shape_, part);
    }
  }

  In_between_shape& shape_;
  std::vector<contacts::Triangle_pair> nearest_; ///< by contact, where it was closest
  int round_ = 0;
};

} // namespace

Relaxation relax_contacts(In_between_shape& shape)
{
  constexpr std::size_t most_rounds = 20;
  constexpr std::size_t patience = 4; // rounds in which it is to get better by
  constexpr double progress = 0.8;    // at least: else parts are at their bounds
  Contact_relaxation relaxation(shape);
  std::vector<double> open;
  while (open.size() < most_rounds) {
    open.push_back(relaxation.improve());
    if (open.back() == 0) return open.size() == 1 ? Relaxation::NOTHING_TO_DO : Relaxation::CLOSED;
    if (open.size() > patience && open.back() > progress * open[open.size() - 1 - patience]) break;
  }
  return Relaxation::OPEN;
}

} // namespace CGAL::Shape_correspondence::internal

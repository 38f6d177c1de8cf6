// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_BLEND_BLEND_SETTLING_H
#define CGAL_SHAPE_CORRESPONDENCE_BLEND_BLEND_SETTLING_H

// How the parts of a blend come together that have changed each for itself: contacts, feet, and sets that came apart.

#include "blend/Affine_moves.h"
#include "blend/Blend_scene.h"
#include "blend/Joined_sets.h"

#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

/// Closes contacts and moves together what has come apart, in turns, since the one may undo the other.
inline void Blend_scene::settle()
{
  constexpr int most_turns = 4;
  for (int turn = 0; turn < most_turns; ++turn) {
    const int rounds = relink();
    if (turn > 0 && rounds == 0) return;
    fade();
    if (!join() || rounds == most_rounds) return;
  }
}

/// How high the foot of a part that stands is above the ground at the ends, in between.
inline double Blend_scene::foot_level(std::size_t actor) const
{
  return (1 - t_) * cast_.actors[actor].foot[0] + t_ * cast_.actors[actor].foot[1];
}

/// How far a part that stands is to rise to be as high above the ground as it is at the ends.
inline double Blend_scene::rise_to_stand(std::size_t actor) const
{
  return ground() + foot_level(actor) - lowest(actor);
}

/// The middle of the lowest points.
inline Point Blend_scene::foot(std::size_t actor) const
{
  constexpr double level = 1e-3;
  const Points& of_actor = points(actor, surface_[actor]);
  const double low = lowest(actor);
  Point sum = Point::Zero();
  int count = 0;
  for (Eigen::Index i = 0; i < of_actor.cols(); ++i)
    if (of_actor(1, i) <= low + level) sum += of_actor.col(i), ++count;
  return sum / count;
}

/// Closes the gaps of links between parts that stay and puts feet on the ground: all move at once by the affine moves
/// nearest to that, mirror images alike. Returns how often; `most_rounds`: to no avail.
inline int Blend_scene::relink()
{
  constexpr double inertia = 0.01; // of a part as large as the shape is high, against a pull of 1
  const std::size_t count = points_.size();
  Trees trees = this->trees();
  std::vector<contacts::Triangle_pair> near(cast_.links.size());
  for (int round = 0; round < most_rounds; ++round) {
    std::vector<Movable_body> bodies(count);
    for (std::size_t a = 0; a < count; ++a) {
      if (!is_there(a)) continue;
      if (round > 0) refit(*trees[a], a);
      const double size = std::max(trees[a]->box().diagonal().norm(), least_stretched * cast_.sizes[a]);
      bodies[a] = {trees[a]->box().center(), size, inertia * size};
    }
    Affine_moves moves(std::move(bodies));
    bool is_good = true;
    for (std::size_t l = 0; l < near.size(); ++l) {
      const auto [a, b] = cast_.links[l].actors;
      const double allowed = cast_.links[l].allowed(t_);
      const contacts::Closest_pair closest = trees[a]->nearly_closest(*trees[b], allowed + closed, near[l]);
      const double gap = std::sqrt(closest.squared);
      if (gap + joined < allowed) continue; // it holds nothing
      Point step = Point::Zero();
      if (gap > allowed + closed) {
        step = (gap - allowed) / gap * (closest.second - closest.first);
        is_good = false;
      }
      moves.pull(a, closest.first, b, closest.second, step);
      const std::size_t image_a = cast_.actors[a].twin, image_b = cast_.actors[b].twin;
      if (image_a != Mirror_twins::none && image_b != Mirror_twins::none)
        moves.pull(image_a, mirrored(closest.first), image_b, mirrored(closest.second), mirrored(step));
    }
    for (std::size_t a = 0; a < count; ++a) {
      if (!is_there(a)) continue;
      const double below = ground() - lowest(a), rise = cast_.actors[a].stands ? rise_to_stand(a) : std::max(0., below);
      if (!cast_.actors[a].stands && below <= 0) continue;
      moves.lift(a, foot(a), rise);
      is_good = is_good && std::abs(rise) <= closed;
    }
    if (is_good) return round;
    const std::vector<Affine_move> solved = moves.solve();
    for (std::size_t a = 0; a < count; ++a) {
      const std::size_t twin = cast_.actors[a].twin;
      const Affine_move move = twin == Mirror_twins::none ? solved[a] : solved[a].symmetrised(solved[twin]);
      for (Points& surface : points_[a])
        move.apply(surface);
      if (is_there(a)) put_foot(a);
    }
  }
  return most_rounds;
}

/// Stretches a part that stands down to its place on the ground, and one that is in the ground up out of it; what is
/// highest stays. What is beyond half of its height, the whole part moves.
inline void Blend_scene::put_foot(std::size_t actor)
{
  constexpr double flat = 1e-6;
  const double rise = cast_.actors[actor].stands ? rise_to_stand(actor) : std::max(0., ground() - lowest(actor));
  const double high = points(actor, surface_[actor]).row(1).maxCoeff(), height = std::max(high - lowest(actor), flat);
  const double stretch = std::clamp(rise, -height / 2, height / 2);
  Affine_move move{Point(0, high, 0), Point(0, rise - stretch, 0), Eigen::Matrix3d::Zero()};
  move.gradient(1, 1) = -stretch / height;
  for (Points& surface : points_[actor])
    move.apply(surface);
}

inline void Blend_scene::move(std::size_t actor, const Point& step)
{
  for (Points& surface : points_[actor])
    if (surface.cols() > 0) surface.colwise() += step;
}

/// Moves sets of parts that have come apart from the rest, the smallest one first, back to what is nearest to them.
/// Returns whether there were any.
inline bool Blend_scene::join()
{
  std::vector<std::size_t> present;
  std::vector<Tree> trees;
  for (std::size_t a = 0; a < points_.size(); ++a)
    if (is_there(a)) present.push_back(a), trees.push_back(tree(a));
  const double allowed = (1 - t_) * cast_.apart[0] + t_ * cast_.apart[1] + joined;
  Joined_sets sets(std::move(trees), allowed);
  constexpr int most_tries = 5;
  std::map<std::size_t, int> tries; // by set, to join it without moving it across the mirror plane
  bool any = false;
  while (const std::optional<std::size_t> set = sets.smallest()) {
    const Joined_sets::Way way = sets.way_from(*set);
    const double gap = std::sqrt(way.closest.squared), excess = std::max(0., gap - allowed);
    apart_ = std::max(apart_, excess);
    if (excess > 0 && std::isfinite(excess)) {
      any = true;
      const Point step = excess / gap * (way.closest.second - way.closest.first);
      const bool is_along_mirror = std::abs(step.x()) < step.norm() / 2 && tries[*set]++ < most_tries;
      if (!move_set(sets, *set, present, present[way.to], way.closest.first, step, is_along_mirror)) continue;
    }
    sets.unite(way.from, way.to);
  }
  return any;
}

/// Moves a set by a step to an actor, and mirror images of its parts alike. Returns whether it goes all of the way.
/// \param from where it is nearest to the actor
/// \param is_along_mirror whether what is its own image is not moved across the mirror plane
inline bool Blend_scene::move_set(Joined_sets& sets, std::size_t set, const std::vector<std::size_t>& present,
                                  std::size_t to, const Point& from, Point step, bool is_along_mirror)
{
  std::vector<char> moves(points_.size(), 0), image_moves(points_.size(), 0);
  for (std::size_t i = 0; i < present.size(); ++i) {
    if (sets.set_of(i) != set) continue;
    moves[present[i]] = 1;
    const std::size_t twin = cast_.actors[present[i]].twin;
    if (twin != Mirror_twins::none) image_moves[twin] = 1;
  }
  if (image_moves[to]) step /= 2; // they move towards each other
  // A set that is its own image gets as much wider on both sides, unless that were more than twice as wide
  const bool is_widened = moves == image_moves && std::abs(step.x()) <= std::abs(from.x());
  bool is_whole = true;
  for (std::size_t i = 0; i < present.size(); ++i) {
    const std::size_t actor = present[i];
    if (!moves[actor] && !image_moves[actor]) continue;
    Affine_move own;
    own.shift = moves[actor] ? step : mirrored(step);
    if (is_widened) {
      own.shift.x() = 0;
      own.gradient(0, 0) = step.x() != 0 ? step.x() / from.x() : 0;
    } else if (moves[actor] && image_moves[actor] && is_along_mirror) {
      is_whole = is_whole && std::abs(own.shift.x()) <= closed;
      own.shift.x() = 0;
    }
    for (Points& surface : points_[actor])
      own.apply(surface);
    sets.update(i, tree(actor));
  }
  return is_whole;
}

/// Lifts the shape out of the ground, or puts it there if no part of it is to stand.
inline void Blend_scene::stand()
{
  double low = std::numeric_limits<double>::infinity();
  bool stands = false;
  for (std::size_t a = 0; a < points_.size(); ++a) {
    if (!is_there(a)) continue;
    low = std::min(low, lowest(a));
    stands = stands || cast_.actors[a].stands;
  }
  const double lift = stands ? std::max(0., ground() - low) : ground() - low;
  for (std::size_t a = 0; a < points_.size(); ++a)
    move(a, Point(0, lift, 0));
}

} // namespace internal
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_BLEND_BLEND_SETTLING_H

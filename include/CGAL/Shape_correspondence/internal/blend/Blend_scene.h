// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_INTERNAL_BLEND_BLEND_SCENE_H
#define CGAL_SHAPE_CORRESPONDENCE_INTERNAL_BLEND_BLEND_SCENE_H

#include <CGAL/Shape_correspondence/internal/blend/Affine_moves.h>
#include <CGAL/Shape_correspondence/internal/blend/Blend_cast.h>
#include <CGAL/Shape_correspondence/internal/blend/Joined_sets.h>

#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

/// The surfaces of all actors of a blend at a time strictly between its ends.
class Blend_scene
{
public:
  using Tree = contacts::Triangle_tree;
  using Trees = std::vector<std::optional<Tree>>;   ///< by actor, of what there is of it
  using Times = std::vector<std::array<double, 2>>; ///< begin and end, by actor

  Blend_scene(const Blend_cast& cast, const Times& times, double t);

  double time() const { return t_; }
  /// The points of an actor's surface.
  const Points& points(std::size_t actor, int surface) const { return points_[actor][std::size_t(surface)]; }
  /// The one of an actor's surfaces that there is, or -1.
  int surface(std::size_t actor) const { return surface_[actor]; }
  bool is_there(std::size_t actor) const { return surface_[actor] >= 0; }
  Trees trees() const;

  /// By how much a contact that is to be kept is wider than it may be, at most, and between which actors.
  struct Open_contact
  {
    double gap = 0;
    std::array<std::size_t, 2> actors{};
  };
  Open_contact widest_contact(const Trees& trees) const;
  /// How far sets of parts had come apart that were joined again.
  double apart() const { return apart_; }
  /// How far a part that stands is above the place on the ground, or above it, that it has at the ends, or below it
  /// (negative), where that is most.
  struct Lifted_foot
  {
    double height = 0;
    std::size_t actor = 0;
  };
  Lifted_foot worst_foot() const;

private:
  static constexpr double closed = 1e-4;  ///< a gap that is none
  static constexpr double joined = 0.005; ///< over what the ends have, the widest gap between sets of parts
  static constexpr int most_rounds = 20;  ///< of closing contacts
  /// Of its full size: what is smaller is moved as it is, not stretched, which would tear what it becomes apart.
  static constexpr double least_stretched = 0.1;

  /// How far parts are symmetric: wholly from the end of the first quarter to the begin of the last one.
  double mirror_share() const { return std::min({1., 4 * t_, 4 * (1 - t_)}); }
  Tree tree(std::size_t actor) const;
  void refit(Tree& tree, std::size_t actor) const;
  double ground() const { return (1 - t_) * cast_.ends.ground[0] + t_ * cast_.ends.ground[1]; }
  double lowest(std::size_t actor) const { return points_[actor][std::size_t(surface_[actor])].row(1).minCoeff(); }
  double foot_level(std::size_t actor) const;
  double rise_to_stand(std::size_t actor) const;
  Point foot(std::size_t actor) const;
  void morph(const Times& times);
  void fade();
  void mirror();
  void meet_image(std::size_t actor);
  void settle();
  int relink();
  bool join();
  bool move_set(Joined_sets& sets, std::size_t set, const std::vector<std::size_t>& present, std::size_t to, Point step,
                bool is_along_mirror);
  void stand();
  void put_foot(std::size_t actor);
  void move(std::size_t actor, const Point& step);

  const Blend_cast& cast_;
  double t_;
  std::vector<std::array<Points, 2>> points_; ///< by actor and surface
  std::vector<int> surface_;
  std::vector<double> left_; ///< by actor, how much there is of one that fades
  double apart_ = 0;
};

inline Blend_scene::Blend_scene(const Blend_cast& cast, const Times& times, double t)
    : cast_(cast), t_(t), points_(cast.actors.size()), surface_(cast.actors.size(), -1), left_(cast.actors.size(), 1)
{
  morph(times);
  mirror();
  settle();
  stand();
}

inline Blend_scene::Tree Blend_scene::tree(std::size_t actor) const
{
  Tree result = *cast_.trees[actor][std::size_t(surface_[actor])];
  refit(result, actor);
  return result;
}

/// Moves a tree of an actor's surface to where that is now.
inline void Blend_scene::refit(Tree& tree, std::size_t actor) const
{
  const int surface = surface_[actor];
  tree.move([&](std::size_t t) { return triangle_of(points(actor, surface), cast_.triangles(actor, surface), t); });
}

inline Blend_scene::Trees Blend_scene::trees() const
{
  Trees result(points_.size());
  for (std::size_t a = 0; a < points_.size(); ++a)
    if (is_there(a)) result[a] = tree(a);
  return result;
}

/// Parts that correspond morph, without regard to each other.
inline void Blend_scene::morph(const Times& times)
{
  for (std::size_t a = 0; a < points_.size(); ++a) {
    const Blend_actor& actor = cast_.actors[a];
    const double own = std::clamp((t_ - times[a][0]) / (times[a][1] - times[a][0]), 0., 1.);
    if (actor.morph) {
      surface_[a] = actor.morph->carrier(own);
      for (int surface : {0, 1})
        points_[a][std::size_t(surface)] = actor.points(surface, own);
    } else {
      left_[a] = actor.side() == 0 ? 1 - own : own;
    }
  }
}

/// Parts without counterpart are as much as is left of them, and follow what they hang on; none goes into the ground.
inline void Blend_scene::fade()
{
  constexpr int rounds = 4;
  for (std::size_t a = 0; a < points_.size(); ++a) {
    const Blend_actor& actor = cast_.actors[a];
    if (actor.morph) continue;
    if (left_[a] > 0) surface_[a] = 0;
    Points& points = points_[a][0] = actor.points_left(left_[a]);
    const double size =
        std::max((points.rowwise().maxCoeff() - points.rowwise().minCoeff()).norm(), least_stretched * cast_.sizes[a]);
    std::vector<Handle> handles;
    for (const Blend_attachment& on : cast_.attachments[a]) {
      const Point there = on.place.of(this->points(on.actor, on.surface), cast_.triangles(on.actor, on.surface));
      handles.push_back({actor.place(on.at, left_[a]), there - on.at});
    }
    for (int round = 0; round < rounds; ++round) {
      const Affine_move move = following(handles, size);
      move.apply(points);
      for (Handle& handle : handles) {
        const Point step = move.of(handle.at);
        handle.at += step;
        handle.move -= step;
      }
    }
    points.row(1) = points.row(1).cwiseMax(ground());
  }
  for (std::size_t a = 0; a < points_.size(); ++a)
    if (cast_.actors[a].fading) meet_image(a);
}

/// Makes mirror images mirror images of each other, first their boxes and then their surfaces: each one goes half of
/// the way to the other. At the ends, which need not be quite symmetric, nothing moves.
inline void Blend_scene::mirror()
{
  constexpr double flat = 1e-6;
  const double share = mirror_share();
  std::vector<contacts::Box> boxes(points_.size());
  for (std::size_t a = 0; a < points_.size(); ++a)
    if (is_there(a))
      boxes[a] = {points(a, surface_[a]).rowwise().minCoeff(), points(a, surface_[a]).rowwise().maxCoeff()};
  for (std::size_t a = 0; a < points_.size(); ++a) {
    const std::size_t twin = cast_.actors[a].twin;
    if (twin == Mirror_twins::none || !is_there(a) || !is_there(twin)) continue;
    const Point middle = boxes[a].center(), size = boxes[a].sizes();
    const Point shift = share / 2 * (mirrored(Point(boxes[twin].center())) - middle);
    const Point growth = share / 2 * (boxes[twin].sizes() - size).cwiseQuotient(size.cwiseMax(flat));
    for (Points& surface : points_[a])
      Affine_move{middle, shift, growth.asDiagonal()}.apply(surface);
  }
  for (std::size_t a = 0; a < points_.size(); ++a)
    meet_image(a);
}

/// Moves every point of a part and of its mirror image half of the way to where the other is, seen in the mirror, some
/// times over.
inline void Blend_scene::meet_image(std::size_t actor)
{
  constexpr double alike = 5e-4; // so near that nothing needs to be done
  constexpr int most_rounds = 4;
  const std::size_t twin = cast_.actors[actor].twin;
  if (twin == Mirror_twins::none || twin < actor || !is_there(actor) || !is_there(twin)) return;
  const std::array<std::size_t, 2> both = {actor, twin};
  const auto own = [&](std::size_t i) -> Points& { return points_[both[i]][std::size_t(surface_[both[i]])]; };
  std::array<std::vector<std::size_t>, 2> nearest_triangles; // by own point, to begin with in the next round
  for (int round = 0; round < most_rounds; ++round) {
    const std::array<Tree, 2> trees = {tree(actor), tree(twin)};
    if (std::max(mirror_distance(own(0), trees[1]), mirror_distance(own(1), trees[0])) <= alike) return;
    for (std::size_t i = 0; i < (actor == twin ? 1 : 2); ++i) {
      std::vector<std::size_t>& triangles = nearest_triangles[i];
      triangles.resize(std::size_t(own(i).cols()), 0);
      for (std::size_t k = 0; k < triangles.size(); ++k) {
        if (round == 0 && k > 0) triangles[k] = triangles[k - 1];
        auto p = own(i).col(Eigen::Index(k));
        p += mirror_share() / 2 * (mirrored(trees[1 - i].nearest(mirrored(Point(p)), triangles[k])) - p);
      }
    }
  }
}

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
      if (!move_set(sets, *set, present, present[way.to], step, is_along_mirror)) continue;
    }
    sets.unite(way.from, way.to);
  }
  return any;
}

/// Moves a set by a step to an actor, and mirror images of its parts alike. Returns whether it goes all of the way.
/// \param is_along_mirror whether what is its own image is not moved across the mirror plane
inline bool Blend_scene::move_set(Joined_sets& sets, std::size_t set, const std::vector<std::size_t>& present,
                                  std::size_t to, Point step, bool is_along_mirror)
{
  std::vector<char> moves(points_.size(), 0), image_moves(points_.size(), 0);
  for (std::size_t i = 0; i < present.size(); ++i) {
    if (sets.set_of(i) != set) continue;
    moves[present[i]] = 1;
    const std::size_t twin = cast_.actors[present[i]].twin;
    if (twin != Mirror_twins::none) image_moves[twin] = 1;
  }
  if (image_moves[to]) step /= 2; // they move towards each other
  bool is_whole = true;
  for (std::size_t i = 0; i < present.size(); ++i) {
    const std::size_t actor = present[i];
    if (!moves[actor] && !image_moves[actor]) continue;
    Point own = moves[actor] ? step : mirrored(step);
    if (moves[actor] && image_moves[actor] && is_along_mirror) {
      is_whole = is_whole && std::abs(own.x()) <= closed;
      own.x() = 0;
    }
    move(actor, own);
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

inline Blend_scene::Open_contact Blend_scene::widest_contact(const Trees& trees) const
{
  Open_contact widest;
  for (const Blend_link& link : cast_.links) {
    const auto [a, b] = link.actors;
    const double allowed = link.allowed(t_);
    const double gap = std::sqrt(trees[a]->nearly_closest(*trees[b], allowed).squared) - allowed;
    if (gap > widest.gap) widest = {gap, link.actors};
  }
  return widest;
}

inline Blend_scene::Lifted_foot Blend_scene::worst_foot() const
{
  Lifted_foot worst;
  for (std::size_t a = 0; a < points_.size(); ++a) {
    const double height = is_there(a) && cast_.actors[a].stands ? -rise_to_stand(a) : 0;
    if (std::abs(height) > std::abs(worst.height)) worst = {height, a};
  }
  return worst;
}

} // namespace internal
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_INTERNAL_BLEND_BLEND_SCENE_H

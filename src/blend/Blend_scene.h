// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_BLEND_BLEND_SCENE_H
#define CGAL_SHAPE_CORRESPONDENCE_BLEND_BLEND_SCENE_H

#include "blend/Affine_moves.h"
#include "blend/Blend_cast.h"
#include "blend/Joined_sets.h"

#include <algorithm>
#include <array>
#include <cmath>
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
  bool move_set(Joined_sets& sets, std::size_t set, const std::vector<std::size_t>& present, std::size_t to,
                const Point& from, Point step, bool is_along_mirror);
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

#include "blend/Blend_settling.h"

#endif // CGAL_SHAPE_CORRESPONDENCE_BLEND_BLEND_SCENE_H

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_INTERNAL_BLEND_BLEND_STAGE_H
#define CGAL_SHAPE_CORRESPONDENCE_INTERNAL_BLEND_BLEND_STAGE_H

#include <CGAL/Shape_correspondence/blend_shapes.h>
#include <CGAL/Shape_correspondence/internal/blend/Fading_part.h>
#include <CGAL/Shape_correspondence/internal/blend/Part_morph.h>

#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

/// The parts of a blend and how they hang together, in the common frame of both shapes.
class Blend_stage
{
public:
  using Times = std::vector<std::array<double, 2>>; ///< begin and end, by actor

  /// One shape of the blend.
  struct Side
  {
    const Structural_graph& graph;
    const Segmented_shape& shape;
    int quarter_turns;
  };

  /// What one part, or a piece of one, goes through: one surface or two that follow each other.
  struct Actor
  {
    std::string name;
    Blend_task task;
    std::optional<Part_morph> morph; ///< or else it fades
    std::optional<Fading_part> fading;
    double height = 0; ///< of its middle, at the ends' mean

    int side() const { return task.source == Blend_task::no_part ? 1 : 0; } ///< of one that fades
  };

  /// The surfaces of all actors at a time.
  struct Scene
  {
    std::vector<std::array<Points, 2>> points; ///< by actor and surface
    std::vector<int> surface;                  ///< by actor, the one that there is, or -1
    double gap = 0;                            ///< the widest that a contact is more than it may be
    double apart = 0;                          ///< how far sets of parts had come apart that were joined again
  };

  Blend_stage(const Side& source, const Side& target, const Correspondence& correspondence, double contact_tolerance);

  const std::vector<Actor>& actors() const { return actors_; }
  /// The shapes of the ends as they were given.
  const Segmented_shape& end(int side) const { return shapes_[std::size_t(side)]; }

  /// \param t strictly between 0 and 1
  Scene scene(const Times& times, double t) const;
  /// Of a scene, or of an end of the blend where `t` is 0 or 1.
  Blend_quality quality(const Scene& scene, double t) const;
  /// From the common frame to the place that the shape has at `t`.
  Points to_world(const Points& points, double t) const;
  Point up(double t) const;

  const Eigen::Matrix3Xi& triangles(std::size_t actor, int surface) const
  {
    return actors_[actor].morph ? actors_[actor].morph->triangles(surface) : actors_[actor].fading->triangles();
  }

private:
  using Tree = contacts::Triangle_tree;

  /// Where a fading part hangs on another actor.
  struct Attachment
  {
    std::size_t actor;
    int surface;
    Mesh_place place;
    Point at;
  };

  /// Two actors that touch at an end of the blend, or at both.
  struct Link
  {
    std::array<std::size_t, 2> actors;
    std::array<bool, 2> touch = {false, false};
    std::array<double, 2> gap = {0, 0};

    /// How wide the gap may be. A contact that both ends have goes from the one to the other; one that joins what
    /// nothing else does lasts for one half of the blend and comes about, or is given up, in the other.
    double allowed(double t) const
    {
      const double f = touch[0] && touch[1] ? t : touch[0] ? std::max(0., 2 * t - 1) : std::min(1., 2 * t);
      return (1 - f) * gap[0] + f * gap[1];
    }
  };

  void add_morphs(const std::array<Charted_shape, 2>& charted, const Correspondence& correspondence);
  void add_fading(const Side& given, int side, const Charted_shape& charted);
  void add_links(const std::array<Side, 2>& sides, double tolerance);
  void add_morph_links(std::vector<Link> links);
  Attachment attachment(const std::vector<std::size_t>& candidates, int side, const Point& at) const;
  std::vector<std::size_t> actors_of(int side, std::size_t part) const;
  Points end_points(std::size_t actor, int side) const;
  bool exists(std::size_t actor, int side) const { return actors_[actor].morph || actors_[actor].side() == side; }
  void relink(double t, Scene& scene) const;
  void join(double t, Scene& scene) const;
  void stand(double t, Scene& scene) const;
  double widest_gap(std::size_t side) const;
  Tree tree(const Scene& scene, std::size_t actor) const;

  std::array<Segmented_shape, 2> shapes_;
  std::array<Shape_frame, 2> frames_; ///< turned so that both shapes look alike
  std::array<std::vector<Part_mesh>, 2> meshes_;
  static constexpr double joined = 0.005; ///< over what the ends have, the widest gap between sets of parts

  std::array<double, 2> ground_ = {0, 0};
  std::array<double, 2> apart_ = {0, 0}; ///< the widest gap that it takes to join all parts
  bool mirror_ = false;
  std::vector<Actor> actors_;
  std::vector<std::vector<Attachment>> attachments_; ///< by actor
  std::vector<Link> links_;
  std::vector<std::array<std::optional<Tree>, 2>> trees_; ///< by actor and surface, at an end; to be moved
};

inline Blend_stage::Blend_stage(const Side& source, const Side& target, const Correspondence& correspondence,
                                double contact_tolerance)
    : shapes_{source.shape, target.shape}
{
  const std::array<Side, 2> sides = {source, target};
  std::array<Charted_shape, 2> charted;
  for (std::size_t s = 0; s < 2; ++s) {
    const Side& side = sides[s];
    frames_[s] = structure(side.graph).frame;
    std::vector<const Points*> surfaces;
    for (const Shape_part& part : side.shape.parts())
      surfaces.push_back(&part.mesh.points);
    charted[s] = charted_shape(side.graph, side.quarter_turns, surfaces);
    ground_[s] = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
      meshes_[s].push_back({charted[s].surfaces[i], side.shape.parts()[i].mesh.triangles});
      ground_[s] = std::min(ground_[s], charted[s].surfaces[i].row(1).minCoeff());
    }
    apart_[s] = widest_gap(s);
    frames_[s].axes = frames_[s].axes * quarter_turn(side.quarter_turns).transpose();
  }
  const auto mirrored = [](const Side& side) {
    const Shape_frame& frame = structure(side.graph).frame;
    return side.quarter_turns % 2 == 0 ? frame.mirror_x : frame.mirror_z;
  };
  mirror_ = mirrored(source) && mirrored(target);
  add_morphs(charted, correspondence);
  attachments_.resize(actors_.size());
  add_fading(source, 0, charted[0]);
  add_fading(target, 1, charted[1]);
  add_links(sides, contact_tolerance);
}

inline void Blend_stage::add_morphs(const std::array<Charted_shape, 2>& charted, const Correspondence& correspondence)
{
  const std::vector<Part_pair> pairs = part_pairs(charted[0], charted[1], correspondence);
  const auto piece = [&](int side, std::size_t part, const Chart_box& box) {
    const auto s = std::size_t(side);
    return piece_of(meshes_[s][part].points, meshes_[s][part].triangles, charted[s].charts[part], box);
  };
  for (const Part_pair& pair : pairs) {
    const auto shares_source = [&](const Part_pair& other) { return other.source == pair.source; };
    const auto shares_target = [&](const Part_pair& other) { return other.target == pair.target; };
    const bool splits = std::count_if(pairs.begin(), pairs.end(), shares_source) > 1;
    const bool merges = std::count_if(pairs.begin(), pairs.end(), shares_target) > 1;
    const Part_mesh from = piece(0, pair.source, pair.source_piece), to = piece(1, pair.target, pair.target_piece);
    Actor actor;
    actor.name = charted[0].parts[pair.source]->name + '~' + charted[1].parts[pair.target]->name;
    actor.task.type = merges ? Blend_task_type::MERGE : splits ? Blend_task_type::SPLIT : Blend_task_type::MORPH;
    actor.task.source = pair.source;
    actor.task.target = pair.target;
    actor.morph.emplace(pair_charts(pair, charted[0], charted[1], from.points, to.points), from, to);
    actor.height = (from.points.row(1).mean() + to.points.row(1).mean()) / 2;
    actors_.push_back(std::move(actor));
  }
}

inline std::vector<std::size_t> Blend_stage::actors_of(int side, std::size_t part) const
{
  std::vector<std::size_t> result;
  for (std::size_t a = 0; a < actors_.size(); ++a)
    if ((side == 0 ? actors_[a].task.source : actors_[a].task.target) == part) result.push_back(a);
  return result;
}

inline Points Blend_stage::end_points(std::size_t actor, int side) const
{
  return actors_[actor].morph ? actors_[actor].morph->points(side, side) : actors_[actor].fading->points(1);
}

inline Blend_stage::Attachment Blend_stage::attachment(const std::vector<std::size_t>& candidates, int side,
                                                       const Point& at) const
{
  Attachment best{};
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t actor : candidates) {
    const int surface = actors_[actor].morph ? side : 0;
    const Points points = end_points(actor, side);
    const Mesh_place place = nearest_place(tree_of(points, triangles(actor, surface)), at);
    const Point p = place.of(points, triangles(actor, surface));
    if ((p - at).squaredNorm() >= least) continue;
    least = (p - at).squaredNorm();
    best = {actor, surface, place, p};
  }
  return best;
}

/// Parts without counterpart, in layers: what touches matched parts first, then what touches that.
inline void Blend_stage::add_fading(const Side& given, int side, const Charted_shape& charted)
{
  const Shape_structure& shape = structure(given.graph);
  std::vector<char> placed(shape.parts.size(), 0);
  for (std::size_t part = 0; part < placed.size(); ++part)
    placed[part] = !actors_of(side, part).empty();
  const auto add = [&](std::size_t part) {
    std::vector<Attachment> attachments;
    std::vector<Point> anchors;
    const auto attach = [&](std::size_t other, const Eigen::Vector2d& parameter) {
      const Point place = to_common_frame(shape.frame, given.quarter_turns, evaluate(shape.parts[part], parameter));
      attachments.push_back(attachment(actors_of(side, other), side, place));
      anchors.push_back(attachments.back().at);
    };
    for (const Contact& contact : shape.contacts)
      for (std::size_t i : {0u, 1u}) {
        if (contact.parts[i] != part || placed[contact.parts[1 - i]] != 1) continue;
        attach(contact.parts[1 - i], contact.parameters[i]);
        for (const Contact::Parameters& further : contact.further)
          attach(contact.parts[1 - i], further[i]);
      }
    Actor actor;
    actor.name = side == 0 ? shape.parts[part].name + '~' : '~' + shape.parts[part].name;
    actor.task.type = side == 0 ? Blend_task_type::SHRINK : Blend_task_type::GROW;
    (side == 0 ? actor.task.source : actor.task.target) = part;
    actor.fading.emplace(charted.charts[part], meshes_[std::size_t(side)][part], anchors);
    actor.height = meshes_[std::size_t(side)][part].points.row(1).mean();
    actors_.push_back(std::move(actor));
    attachments_.push_back(std::move(attachments));
  };
  constexpr char now = 2;
  for (bool any = true; any;) {
    any = false;
    for (const Contact& contact : shape.contacts)
      for (std::size_t i : {0u, 1u})
        if (placed[contact.parts[1 - i]] == 1 && placed[contact.parts[i]] == 0) placed[contact.parts[i]] = now;
    for (std::size_t part = 0; part < placed.size(); ++part)
      if (placed[part] == now) add(part), any = true;
    std::replace(placed.begin(), placed.end(), now, char(1));
  }
  for (std::size_t part = 0; part < placed.size(); ++part)
    if (!placed[part]) add(part);
}

inline void Blend_stage::add_links(const std::array<Side, 2>& sides, double tolerance)
{
  std::map<std::array<std::size_t, 2>, std::array<bool, 2>> candidates; // by pair of actors: a contact at that end
  const auto add = [&](const std::vector<std::size_t>& first, const std::vector<std::size_t>& second, std::size_t side,
                       bool of_whole_parts) {
    for (std::size_t a : first)
      for (std::size_t b : second)
        if (a != b) candidates[{std::min(a, b), std::max(a, b)}][side] |= of_whole_parts;
  };
  for (std::size_t side = 0; side < 2; ++side) {
    const Shape_structure& shape = structure(sides[side].graph);
    for (const Contact& contact : shape.contacts) {
      const auto first = actors_of(int(side), contact.parts[0]), second = actors_of(int(side), contact.parts[1]);
      add(first, second, side, first.size() == 1 && second.size() == 1);
    }
    for (std::size_t part = 0; part < shape.parts.size(); ++part)
      add(actors_of(int(side), part), actors_of(int(side), part), side, false);
  }
  trees_.resize(actors_.size());
  for (std::size_t a = 0; a < actors_.size(); ++a)
    for (int side : {0, 1}) {
      const int surface = actors_[a].morph ? side : 0;
      if (exists(a, side)) trees_[a][std::size_t(surface)] = tree_of(end_points(a, side), triangles(a, surface));
    }
  const auto tree_at = [&](std::size_t actor, std::size_t side) {
    return exists(actor, int(side)) ? &*trees_[actor][actors_[actor].morph ? side : 0] : nullptr;
  };
  std::vector<Link> links;
  for (const auto& [actors, contact] : candidates) {
    Link link;
    link.actors = actors;
    for (std::size_t side = 0; side < 2; ++side) {
      const Tree *first = tree_at(actors[0], side), *second = tree_at(actors[1], side);
      if (!first || !second) continue;
      const contacts::Closest_pair closest = first->nearly_closest(*second);
      link.gap[side] = std::sqrt(closest.squared);
      link.touch[side] = contact[side] || link.gap[side] <= tolerance;
    }
    if (link.touch[0] || link.touch[1]) links.push_back(link);
  }
  for (Link& link : links) {
    const auto [a, b] = link.actors;
    if (actors_[a].morph && actors_[b].morph) continue;
    // A part that fades keeps hold of what it hangs on
    const auto hangs = [&](std::size_t part, std::size_t on) {
      const auto& list = attachments_[part];
      return std::any_of(list.begin(), list.end(), [&](const Attachment& x) { return x.actor == on; });
    };
    if (!hangs(a, b) && !hangs(b, a)) continue;
    link.gap[0] = link.gap[1] = link.touch[0] ? link.gap[0] : link.gap[1];
    link.touch = {true, true};
    links_.push_back(link);
  }
  add_morph_links(links);
}

/// Of parts that stay, contacts of both ends are kept, and as many more of either end as it takes to join what they
/// leave apart: those first that come apart least.
inline void Blend_stage::add_morph_links(std::vector<Link> links)
{
  const auto apart = [](const Link& link) { return quantized(std::max(link.gap[0], link.gap[1])); };
  std::stable_sort(links.begin(), links.end(), [&](const Link& a, const Link& b) { return apart(a) < apart(b); });
  std::vector<char> is_kept(links.size(), 0);
  for (std::size_t side = 0; side < 2; ++side) {
    std::vector<std::size_t> root(actors_.size());
    std::iota(root.begin(), root.end(), std::size_t(0));
    const auto find = [&](std::size_t i) {
      while (root[i] != i)
        i = root[i];
      return i;
    };
    for (bool both : {true, false})
      for (std::size_t l = 0; l < links.size(); ++l) {
        const auto [a, b] = links[l].actors;
        const bool wanted = both ? links[l].touch[0] && links[l].touch[1] : links[l].touch[side];
        if (!wanted || !actors_[a].morph || !actors_[b].morph || (!both && find(a) == find(b))) continue;
        root[find(a)] = find(b);
        is_kept[l] = 1;
      }
  }
  for (std::size_t l = 0; l < links.size(); ++l)
    if (is_kept[l]) links_.push_back(links[l]);
}

inline Blend_stage::Tree Blend_stage::tree(const Scene& scene, std::size_t actor) const
{
  const auto surface = std::size_t(scene.surface[actor]);
  Tree result = *trees_[actor][surface];
  result.move(
      [&](std::size_t t) { return triangle_of(scene.points[actor][surface], triangles(actor, int(surface)), t); });
  return result;
}

inline Blend_stage::Scene Blend_stage::scene(const Times& times, double t) const
{
  Scene result;
  result.points.resize(actors_.size());
  result.surface.resize(actors_.size(), -1);
  for (std::size_t a = 0; a < actors_.size(); ++a) {
    const Actor& actor = actors_[a];
    const double own = std::clamp((t - times[a][0]) / (times[a][1] - times[a][0]), 0., 1.);
    if (actor.morph) {
      result.surface[a] = actor.morph->carrier(own);
      for (int surface : {0, 1})
        result.points[a][std::size_t(surface)] = actor.morph->points(surface, own);
      continue;
    }
    const double left = actor.side() == 0 ? 1 - own : own;
    if (left > 0) result.surface[a] = 0;
    Points& points = result.points[a][0];
    points = actor.fading->points(left);
    std::vector<Handle> handles;
    for (const Attachment& on : attachments_[a]) {
      const Points& other = result.points[on.actor][std::size_t(on.surface)];
      handles.push_back({on.at, on.place.of(other, triangles(on.actor, on.surface)) - on.at});
    }
    follow(handles, points);
  }
  relink(t, result);
  join(t, result);
  stand(t, result);
  return result;
}

/// Closes the gaps of links: both parts move, the smaller one more, and hold on to what else they touch.
inline void Blend_stage::relink(double t, Scene& scene) const
{
  constexpr int most_rounds = 6;
  constexpr double closed = 1e-4;
  std::vector<std::optional<Tree>> trees(actors_.size());
  for (const Link& link : links_)
    for (std::size_t a : link.actors)
      if (scene.surface[a] >= 0 && !trees[a]) trees[a] = tree(scene, a);
  std::vector<contacts::Closest_pair> closest(links_.size());
  std::vector<char> moved(actors_.size(), 1);
  for (int round = 0;; ++round) {
    std::vector<std::vector<Handle>> handles(actors_.size());
    std::vector<char> moves(actors_.size(), 0);
    scene.gap = 0;
    for (std::size_t l = 0; l < links_.size(); ++l) {
      const auto [a, b] = links_[l].actors;
      if (scene.surface[a] < 0 || scene.surface[b] < 0) continue;
      const double allowed = links_[l].allowed(t) + closed;
      if (moved[a] || moved[b]) closest[l] = trees[a]->nearly_closest(*trees[b], allowed * allowed);
      const double gap = std::sqrt(closest[l].squared), excess = gap - allowed;
      scene.gap = std::max(scene.gap, excess);
      Point step = Point::Zero();
      if (excess > 0) {
        step = (excess + closed) / gap * (closest[l].second - closest[l].first);
        moves[a] = moves[b] = 1;
      }
      const bool fades_a = !actors_[a].morph, fades_b = !actors_[b].morph;
      const double size_a = trees[a]->box().diagonal().norm(), size_b = trees[b]->box().diagonal().norm();
      const double share = fades_a != fades_b ? double(fades_a) : size_b / (size_a + size_b);
      handles[a].push_back({closest[l].first, share * step});
      handles[b].push_back({closest[l].second, (share - 1) * step});
    }
    if (scene.gap <= 0 || round == most_rounds) return;
    for (std::size_t a = 0; a < actors_.size(); ++a) {
      if (!moves[a]) continue;
      for (Points& points : scene.points[a])
        if (points.cols() > 0) follow(handles[a], points);
      trees[a] = tree(scene, a);
    }
    moved = std::move(moves);
  }
}

/// Moves sets of parts that have come apart from the rest, the smallest one first, back to what is nearest to them.
inline void Blend_stage::join(double t, Scene& scene) const
{
  std::vector<std::size_t> present;
  std::vector<Tree> trees;
  for (std::size_t a = 0; a < actors_.size(); ++a)
    if (scene.surface[a] >= 0) present.push_back(a), trees.push_back(tree(scene, a));
  const double allowed = (1 - t) * apart_[0] + t * apart_[1] + joined;
  std::vector<std::size_t> set(present.size());
  std::iota(set.begin(), set.end(), std::size_t(0));
  const auto unite = [&](std::size_t a, std::size_t b) {
    std::replace(set.begin(), set.end(), std::max(set[a], set[b]), std::min(set[a], set[b]));
  };
  for (std::size_t a = 0; a < present.size(); ++a)
    for (std::size_t b = a + 1; b < present.size(); ++b)
      if (set[a] != set[b] && trees[a].box().squaredExteriorDistance(trees[b].box()) <= allowed * allowed &&
          trees[a].nearly_closest(trees[b], allowed * allowed).squared <= allowed * allowed)
        unite(a, b);
  for (;;) {
    std::map<std::size_t, double> sizes;
    for (std::size_t a = 0; a < present.size(); ++a)
      sizes[set[a]] += trees[a].box().diagonal().norm();
    if (sizes.size() < 2) return;
    const std::size_t least = std::min_element(sizes.begin(), sizes.end(), [](const auto& a, const auto& b) {
                                return quantized(a.second) < quantized(b.second);
                              })->first;
    contacts::Closest_pair closest;
    std::size_t from = 0, to = 0;
    for (std::size_t a = 0; a < present.size(); ++a)
      for (std::size_t b = 0; b < present.size(); ++b) {
        if (set[a] != least || set[b] == least ||
            trees[a].box().squaredExteriorDistance(trees[b].box()) >= closest.squared)
          continue;
        const contacts::Closest_pair pair = trees[a].nearly_closest(trees[b]);
        if (pair.squared < closest.squared) closest = pair, from = a, to = b;
      }
    const double gap = std::sqrt(closest.squared), excess = std::max(0., gap - allowed);
    scene.apart = std::max(scene.apart, excess);
    const Point step = excess / std::max(gap, joined) * (closest.second - closest.first);
    for (std::size_t a = 0; a < present.size(); ++a) {
      if (set[a] != least || excess == 0) continue;
      for (Points& points : scene.points[present[a]])
        if (points.cols() > 0) points.colwise() += step;
      trees[a] = tree(scene, present[a]);
    }
    unite(from, to);
  }
}

/// The longest of the steps by which all parts are joined.
inline double Blend_stage::widest_gap(std::size_t side) const
{
  std::vector<Tree> trees;
  for (const Part_mesh& mesh : meshes_[side])
    trees.push_back(tree_of(mesh.points, mesh.triangles));
  std::vector<double> distance(trees.size(), std::numeric_limits<double>::infinity());
  std::vector<char> is_joined(trees.size(), 0);
  double widest = 0;
  for (std::size_t next = 0, count = 0; count < trees.size(); ++count) {
    is_joined[next] = 1;
    std::size_t nearest = next;
    for (std::size_t i = 0; i < trees.size(); ++i) {
      if (is_joined[i]) continue;
      distance[i] = std::min(distance[i], std::sqrt(trees[next].nearly_closest(trees[i]).squared));
      if (is_joined[nearest] || distance[i] < distance[nearest]) nearest = i;
    }
    if (nearest != next) widest = std::max(widest, distance[nearest]);
    next = nearest;
  }
  return widest;
}

/// Puts the shape on the ground.
inline void Blend_stage::stand(double t, Scene& scene) const
{
  double lowest = std::numeric_limits<double>::infinity();
  for (std::size_t a = 0; a < actors_.size(); ++a)
    if (scene.surface[a] >= 0)
      lowest = std::min(lowest, scene.points[a][std::size_t(scene.surface[a])].row(1).minCoeff());
  const double lift = (1 - t) * ground_[0] + t * ground_[1] - lowest;
  for (auto& surfaces : scene.points)
    for (Points& points : surfaces)
      if (points.cols() > 0) points.row(1).array() += lift;
}

/// Root mean square distance of points, mirrored in x = 0, from a set of surfaces.
inline double mirror_residual(const std::vector<const Points*>& surfaces,
                              const std::vector<contacts::Triangle_tree>& trees)
{
  constexpr Eigen::Index samples = 24; // of a surface
  double sum = 0;
  int count = 0;
  for (const Points* points : surfaces) {
    const Eigen::Index n = std::min(points->cols(), samples);
    for (Eigen::Index i = 0; i < n; ++i) {
      Point p = points->col(i * points->cols() / n), nearest;
      std::size_t triangle;
      p.x() = -p.x();
      double squared = std::numeric_limits<double>::infinity();
      for (const contacts::Triangle_tree& tree : trees)
        if (tree.box().squaredExteriorDistance(p) < squared) tree.improve_nearest(p, nearest, squared, triangle);
      sum += squared;
      ++count;
    }
  }
  return std::sqrt(sum / count);
}

inline Blend_quality Blend_stage::quality(const Scene& scene, double t) const
{
  Blend_quality result;
  std::vector<const Points*> surfaces;
  std::vector<Tree> trees;
  const auto add = [&](const Points& points, const Eigen::Matrix3Xi& triangles) {
    surfaces.push_back(&points);
    trees.push_back(tree_of(points, triangles));
  };
  if (t <= 0 || t >= 1) {
    for (const Part_mesh& mesh : meshes_[t <= 0 ? 0 : 1])
      add(mesh.points, mesh.triangles);
  } else {
    constexpr double on_ground = 0.02;
    result.gap = scene.gap;
    result.apart = scene.apart;
    for (std::size_t a = 0; a < actors_.size(); ++a) {
      if (scene.surface[a] < 0) continue;
      const Points& points = scene.points[a][std::size_t(scene.surface[a])];
      add(points, triangles(a, scene.surface[a]));
      if (!actors_[a].morph) continue;
      const double from = end_points(a, 0).row(1).minCoeff() - ground_[0];
      const double to = end_points(a, 1).row(1).minCoeff() - ground_[1];
      if (from > on_ground || to > on_ground) continue;
      const double ground = (1 - t) * ground_[0] + t * ground_[1];
      result.ground = std::max(result.ground, points.row(1).minCoeff() - ground - std::max(from, to));
    }
  }
  if (mirror_) result.asymmetry = mirror_residual(surfaces, trees);
  return result;
}

inline Points Blend_stage::to_world(const Points& points, double t) const
{
  const Eigen::Quaterniond from(frames_[0].axes), to(frames_[1].axes);
  const Eigen::Matrix3d axes = from.slerp(t, to).toRotationMatrix();
  const double height = (1 - t) * frames_[0].height + t * frames_[1].height;
  const Point origin = (1 - t) * frames_[0].origin + t * frames_[1].origin;
  return (axes * height * points).colwise() + origin;
}

inline Point Blend_stage::up(double t) const
{
  const Point between = (1 - t) * shapes_[0].up() + t * shapes_[1].up();
  return unit_or(between, shapes_[0].up());
}

} // namespace internal
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_INTERNAL_BLEND_BLEND_STAGE_H

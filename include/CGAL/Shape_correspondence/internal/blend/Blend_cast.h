// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_INTERNAL_BLEND_BLEND_CAST_H
#define CGAL_SHAPE_CORRESPONDENCE_INTERNAL_BLEND_BLEND_CAST_H

#include <CGAL/Shape_correspondence/blend_shapes.h>
#include <CGAL/Shape_correspondence/internal/blend/Fading_part.h>
#include <CGAL/Shape_correspondence/internal/blend/Mirror_twins.h>
#include <CGAL/Shape_correspondence/internal/blend/Part_morph.h>
#include <CGAL/Shape_correspondence/internal/blend/widest_gap.h>

#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

/// One shape of a blend.
struct Blend_side
{
  const Structural_graph& graph;
  const Segmented_shape& shape;
  int quarter_turns;
};

/// What one part, or a piece of one, goes through: one surface or two that follow each other.
struct Blend_actor
{
  std::string name;
  Blend_task task;
  std::optional<Part_morph> morph; ///< or else it fades
  std::optional<Fading_part> fading;
  double height = 0;                     ///< of its middle, at the ends' mean
  std::size_t twin = Mirror_twins::none; ///< its mirror image, where the blend is to be symmetric
  bool is_image = false;                 ///< made in the twin's coordinates, seen in the mirror
  bool stands = false;                   ///< on the ground, at both ends
  std::array<double, 2> foot = {0, 0};   ///< of one that stands, how high it is above the ground, by end

  int side() const { return task.source == Blend_task::no_part ? 1 : 0; } ///< of one that fades
  Points points(int surface, double t) const { return as_made(morph->points(surface, t)); }
  Points points_left(double left) const { return as_made(fading->points(left)); }
  Point place(const Point& p, double left) const
  {
    return is_image ? mirrored(fading->place(mirrored(p), left)) : fading->place(p, left);
  }

private:
  Points as_made(Points points) const { return is_image ? mirrored(std::move(points)) : std::move(points); }
};

/// Where a fading part hangs on another actor.
struct Blend_attachment
{
  std::size_t actor;
  int surface;
  Mesh_place place;
  Point at;
};

/// Two actors that stay and that are to be near each other.
struct Blend_link
{
  std::array<std::size_t, 2> actors;
  std::array<bool, 2> touch = {false, false}; ///< by end
  std::array<double, 2> gap = {0, 0};         ///< by end

  /// How wide the gap may be. A contact that both ends have goes from the one to the other. One of one end only lasts
  /// for its half of the blend and comes about, or is given up, in the other; a bridge, between parts that only parts
  /// that vanish join, has come about in the middle.
  double allowed(double t) const
  {
    if (touch[0] && touch[1]) return (1 - t) * gap[0] + t * gap[1];
    const double before = touch[0] ? gap[0] : std::max(0., 1 - 2 * t) * gap[0];
    const double after = touch[1] ? gap[1] : std::max(0., 2 * t - 1) * gap[1];
    return t < 0.5 ? before : after;
  }
};

/// The parts of a blend and how they hang together, in the common frame of both shapes.
class Blend_cast
{
public:
  using Tree = contacts::Triangle_tree;

  Blend_cast(const Blend_side& source, const Blend_side& target, const Correspondence& correspondence,
             double contact_tolerance);

  std::array<Segmented_shape, 2> shapes; ///< of the ends, as they were given
  std::array<Shape_frame, 2> frames;     ///< turned so that both shapes look alike
  std::array<std::vector<Part_mesh>, 2> meshes;
  std::array<double, 2> ground = {0, 0};
  std::array<double, 2> apart = {0, 0}; ///< the widest gap that it takes to join all parts
  bool mirror = false;                  ///< both shapes have the mirror plane x = 0
  std::vector<Blend_actor> actors;
  std::vector<std::vector<Blend_attachment>> attachments; ///< by actor
  std::vector<Blend_link> links;
  std::vector<std::array<std::optional<Tree>, 2>> trees; ///< by actor and surface, at an end; to be moved

  const Eigen::Matrix3Xi& triangles(std::size_t actor, int surface) const
  {
    return actors[actor].morph ? actors[actor].morph->triangles(surface) : actors[actor].fading->triangles();
  }

private:
  void add_morphs(const std::array<Charted_shape, 2>& charted, const Correspondence& correspondence);
  void add_fading(const Blend_side& given, int side, const Charted_shape& charted);
  void add_links(const std::array<Blend_side, 2>& sides, double tolerance);
  Blend_link link_of(const std::array<std::size_t, 2>& pair, double tolerance) const;
  void choose_links(std::vector<Blend_link> found, double tolerance);
  std::vector<std::array<std::size_t, 2>> bridges(std::size_t side, std::vector<std::size_t> set) const;
  Blend_attachment attachment(const std::vector<std::size_t>& candidates, int side, const Point& at) const;
  std::vector<std::size_t> actors_of(int side, std::size_t part) const;
  Points end_points(std::size_t actor, int side) const;
  bool exists(std::size_t actor, int side) const { return actors[actor].morph || actors[actor].side() == side; }

  std::array<Mirror_twins, 2> twins_; ///< none if the blend is not to be symmetric
};

inline Blend_cast::Blend_cast(const Blend_side& source, const Blend_side& target, const Correspondence& correspondence,
                              double contact_tolerance)
    : shapes{source.shape, target.shape}
{
  const std::array<Blend_side, 2> sides = {source, target};
  std::array<Charted_shape, 2> charted;
  for (std::size_t s = 0; s < 2; ++s) {
    const Blend_side& side = sides[s];
    frames[s] = structure(side.graph).frame;
    std::vector<const Points*> surfaces;
    for (const Shape_part& part : side.shape.parts())
      surfaces.push_back(&part.mesh.points);
    charted[s] = charted_shape(side.graph, side.quarter_turns, surfaces);
    ground[s] = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
      meshes[s].push_back({charted[s].surfaces[i], side.shape.parts()[i].mesh.triangles});
      ground[s] = std::min(ground[s], charted[s].surfaces[i].row(1).minCoeff());
    }
    apart[s] = widest_gap(trees_of(meshes[s]));
    frames[s].axes = frames[s].axes * quarter_turn(side.quarter_turns).transpose();
  }
  const auto mirrored = [](const Blend_side& side) {
    const Shape_frame& frame = structure(side.graph).frame;
    return side.quarter_turns % 2 == 0 ? frame.mirror_x : frame.mirror_z;
  };
  mirror = mirrored(source) && mirrored(target);
  if (mirror) twins_ = {Mirror_twins(meshes[0]), Mirror_twins(meshes[1])};
  for (std::size_t s = 0; s < 2; ++s)
    mirror_charts(meshes[s], twins_[s], charted[s].charts);
  add_morphs(charted, correspondence);
  attachments.resize(actors.size());
  add_fading(source, 0, charted[0]);
  add_fading(target, 1, charted[1]);
  add_links(sides, contact_tolerance);
}

/// A pair for every two parts that become each other and, if the blend is to be symmetric, for their mirror images.
inline void Blend_cast::add_morphs(const std::array<Charted_shape, 2>& charted, const Correspondence& correspondence)
{
  constexpr double on_ground = 0.02;
  Index_pairs paired = correspondence.pairs;
  add_mirrored(paired, twins_[0], twins_[1]);
  paired = paired_parts(charted[0], charted[1], paired);
  add_mirrored(paired, twins_[0], twins_[1]);
  std::vector<Part_pair> pairs = part_pairs(charted[0], charted[1], paired);
  std::vector<std::size_t> twins;
  for (const auto& [s, t] : paired) {
    const auto twin = std::lower_bound(paired.begin(), paired.end(), std::make_pair(twins_[0][s], twins_[1][t]));
    const bool known = twin != paired.end() && *twin == std::make_pair(twins_[0][s], twins_[1][t]);
    twins.push_back(known ? std::size_t(twin - paired.begin()) : Mirror_twins::none);
  }
  // Images need pieces that are images, too: all pairs of a part in the mirror or none
  const auto has_images = [&](const Part_pair& pair) {
    for (std::size_t i = 0; i < pairs.size(); ++i)
      if ((pairs[i].source == pair.source || pairs[i].target == pair.target) && twins[i] == Mirror_twins::none)
        return false;
    return true;
  };
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const Part_pair& pair = pairs[i];
    const auto shares_source = [&](const Part_pair& other) { return other.source == pair.source; };
    const auto shares_target = [&](const Part_pair& other) { return other.target == pair.target; };
    const bool splits = std::count_if(pairs.begin(), pairs.end(), shares_source) > 1;
    const bool merges = std::count_if(pairs.begin(), pairs.end(), shares_target) > 1;
    Blend_actor actor;
    actor.name = charted[0].parts[pair.source]->name + '~' + charted[1].parts[pair.target]->name;
    actor.task.type = merges ? Blend_task_type::MERGE : splits ? Blend_task_type::SPLIT : Blend_task_type::MORPH;
    actor.task.source = pair.source;
    actor.task.target = pair.target;
    actor.twin = twins[i];
    actor.is_image = actor.twin < i && has_images(pair) && has_images(pairs[actor.twin]);
    const Part_pair& made_as = actor.is_image ? pairs[actor.twin] : pair;
    const auto piece = [&](std::size_t s, std::size_t part, std::size_t chart, const Chart_box& box) {
      const Part_mesh& mesh = meshes[s][part];
      return piece_of(actor.is_image ? mirrored(mesh.points) : mesh.points, mesh.triangles, charted[s].charts[chart],
                      box);
    };
    const Part_mesh from = piece(0, pair.source, made_as.source, made_as.source_piece);
    const Part_mesh to = piece(1, pair.target, made_as.target, made_as.target_piece);
    std::optional<bool> forward;
    if (actor.twin < i) forward = actors[actor.twin].morph->is_forward();
    bool upright = false;
    if (actor.twin == i) {
      const std::optional<Eigen::Matrix3d> turn = mirrored_turn(pair, charted[0], charted[1]);
      upright = !turn;
      if (turn) pairs[i].turn = *turn;
    }
    const Pair_charts charts = upright ? upright_charts(from.points, to.points)
                                       : pair_charts(made_as, charted[0], charted[1], from.points, to.points);
    actor.morph.emplace(charts, from, to, forward);
    actor.height = (from.points.row(1).mean() + to.points.row(1).mean()) / 2;
    actor.foot = {from.points.row(1).minCoeff() - ground[0], to.points.row(1).minCoeff() - ground[1]};
    actor.stands = std::max(actor.foot[0], actor.foot[1]) <= on_ground;
    actors.push_back(std::move(actor));
  }
}

inline std::vector<std::size_t> Blend_cast::actors_of(int side, std::size_t part) const
{
  std::vector<std::size_t> result;
  for (std::size_t a = 0; a < actors.size(); ++a)
    if ((side == 0 ? actors[a].task.source : actors[a].task.target) == part) result.push_back(a);
  return result;
}

inline Points Blend_cast::end_points(std::size_t actor, int side) const
{
  return actors[actor].morph ? actors[actor].points(side, side) : actors[actor].points_left(1);
}

inline Blend_attachment Blend_cast::attachment(const std::vector<std::size_t>& candidates, int side,
                                               const Point& at) const
{
  Blend_attachment best{};
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t actor : candidates) {
    const int surface = actors[actor].morph ? side : 0;
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
inline void Blend_cast::add_fading(const Blend_side& given, int side, const Charted_shape& charted)
{
  const Shape_structure& shape = structure(given.graph);
  std::vector<char> placed(shape.parts.size(), 0);
  for (std::size_t part = 0; part < placed.size(); ++part)
    placed[part] = !actors_of(side, part).empty();
  const auto holds_of = [&](std::size_t part) {
    std::vector<Blend_attachment> result;
    const auto attach = [&](std::size_t other, const Eigen::Vector2d& parameter) {
      const Point place = to_common_frame(shape.frame, given.quarter_turns, evaluate(shape.parts[part], parameter));
      result.push_back(attachment(actors_of(side, other), side, place));
    };
    for (const Contact& contact : shape.contacts)
      for (std::size_t i : {0u, 1u}) {
        if (contact.parts[i] != part || placed[contact.parts[1 - i]] != 1) continue;
        attach(contact.parts[1 - i], contact.parameters[i]);
        for (const Contact::Parameters& further : contact.further)
          attach(contact.parts[1 - i], further[i]);
      }
    return result;
  };
  const auto images_of = [&](const std::vector<Blend_attachment>& holds) {
    std::vector<Blend_attachment> result;
    for (const Blend_attachment& hold : holds)
      if (actors[hold.actor].twin != Mirror_twins::none)
        result.push_back(attachment({actors[hold.actor].twin}, side, mirrored(hold.at)));
    return result;
  };
  const auto add = [&](std::size_t part) {
    const std::size_t twin = twins_[std::size_t(side)][part];
    const bool has_image = twin != Mirror_twins::none && twin != part;
    const std::vector<std::size_t> image = has_image ? actors_of(side, twin) : std::vector<std::size_t>();
    Blend_actor actor;
    actor.name = side == 0 ? shape.parts[part].name + '~' : '~' + shape.parts[part].name;
    actor.task.type = side == 0 ? Blend_task_type::SHRINK : Blend_task_type::GROW;
    (side == 0 ? actor.task.source : actor.task.target) = part;
    std::vector<Blend_attachment> holds = holds_of(part);
    if (twin == part) {
      const std::vector<Blend_attachment> images = images_of(holds);
      holds.insert(holds.end(), images.begin(), images.end());
    } else if (!image.empty() && !actors[image[0]].morph) {
      actor.twin = image[0];
      actors[image[0]].twin = actors.size();
      const std::vector<Blend_attachment> images = images_of(attachments[image[0]]);
      actor.is_image = images.size() == attachments[image[0]].size();
      if (actor.is_image) holds = images;
    }
    Part_mesh mesh = meshes[std::size_t(side)][part];
    std::vector<Point> anchors;
    for (const Blend_attachment& hold : holds)
      anchors.push_back(actor.is_image ? mirrored(hold.at) : hold.at);
    if (actor.is_image) mesh.points = mirrored(std::move(mesh.points));
    actor.height = mesh.points.row(1).mean();
    actor.fading.emplace(charted.charts[actor.is_image ? twin : part], mesh, anchors);
    if (twin == part) actor.twin = actors.size();
    actors.push_back(std::move(actor));
    attachments.push_back(std::move(holds));
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

inline void Blend_cast::add_links(const std::array<Blend_side, 2>& sides, double tolerance)
{
  trees.resize(actors.size());
  for (std::size_t a = 0; a < actors.size(); ++a)
    for (int side : {0, 1}) {
      const int surface = actors[a].morph ? side : 0;
      if (exists(a, side)) trees[a][std::size_t(surface)] = tree_of(end_points(a, side), triangles(a, surface));
    }
  std::map<std::array<std::size_t, 2>, std::array<bool, 2>> candidates; // by pair of actors: a contact at that end
  const auto add = [&](std::size_t part, std::size_t other, std::size_t side) {
    const auto first = actors_of(int(side), part), second = actors_of(int(side), other);
    const bool of_whole_parts = part != other && first.size() == 1 && second.size() == 1;
    for (std::size_t a : first)
      for (std::size_t b : second)
        if (a != b && actors[a].morph && actors[b].morph)
          candidates[{std::min(a, b), std::max(a, b)}][side] |= of_whole_parts;
  };
  for (std::size_t side = 0; side < 2; ++side) {
    const Shape_structure& shape = structure(sides[side].graph);
    for (const Contact& contact : shape.contacts)
      add(contact.parts[0], contact.parts[1], side);
    for (std::size_t part = 0; part < shape.parts.size(); ++part)
      add(part, part, side);
  }
  std::vector<Blend_link> found;
  for (const auto& [pair, contact] : candidates) {
    Blend_link link = link_of(pair, tolerance);
    for (std::size_t side : {0u, 1u})
      link.touch[side] = link.touch[side] || contact[side];
    if (link.touch[0] || link.touch[1]) found.push_back(link);
  }
  choose_links(std::move(found), tolerance);
}

inline Blend_link Blend_cast::link_of(const std::array<std::size_t, 2>& pair, double tolerance) const
{
  Blend_link link;
  link.actors = pair;
  for (std::size_t side : {0u, 1u}) {
    link.gap[side] = std::sqrt(trees[pair[0]][side]->nearly_closest(*trees[pair[1]][side]).squared);
    link.touch[side] = link.gap[side] <= tolerance;
  }
  return link;
}

/// Contacts of both ends are kept, and of either end as many more as it takes to join what they leave apart, those
/// first that come apart least; then bridges, the shortest first. What is kept is kept on both sides of the mirror
/// plane.
inline void Blend_cast::choose_links(std::vector<Blend_link> found, double tolerance)
{
  std::map<std::array<std::size_t, 2>, Blend_link> kept;
  const auto keep = [&](const Blend_link& link) {
    kept.emplace(link.actors, link);
    const std::size_t a = actors[link.actors[0]].twin, b = actors[link.actors[1]].twin;
    if (a == Mirror_twins::none || b == Mirror_twins::none || a == b) return;
    kept.emplace(std::array<std::size_t, 2>{std::min(a, b), std::max(a, b)},
                 link_of({std::min(a, b), std::max(a, b)}, tolerance));
  };
  const auto width = [](const Blend_link& link) { return quantized(std::max(link.gap[0], link.gap[1])); };
  std::stable_sort(found.begin(), found.end(),
                   [&](const Blend_link& a, const Blend_link& b) { return width(a) < width(b); });
  for (const Blend_link& link : found)
    if (link.touch[0] && link.touch[1]) keep(link);
  for (std::size_t side = 0; side < 2; ++side) {
    const double joined = std::max(tolerance, apart[side]);
    std::vector<std::size_t> set(actors.size());
    std::iota(set.begin(), set.end(), std::size_t(0));
    const auto unite = [&](const Blend_link& link) {
      const std::size_t a = set[link.actors[0]], b = set[link.actors[1]];
      if (link.gap[side] <= joined) std::replace(set.begin(), set.end(), std::max(a, b), std::min(a, b));
    };
    for (const auto& [pair, link] : kept)
      unite(link);
    for (const Blend_link& link : found) {
      if (set[link.actors[0]] == set[link.actors[1]] || link.gap[side] > joined) continue;
      keep(link);
      unite(link);
    }
    for (const std::array<std::size_t, 2>& pair : bridges(side, set))
      keep(link_of(pair, tolerance));
  }
  for (const auto& [pair, link] : kept)
    links.push_back(link);
}

/// The shortest ways between sets of actors that stay, at an end, as many as join all.
inline std::vector<std::array<std::size_t, 2>> Blend_cast::bridges(std::size_t side, std::vector<std::size_t> set) const
{
  std::vector<std::tuple<long, std::size_t, std::size_t>> ways;
  for (std::size_t a = 0; a < actors.size(); ++a)
    for (std::size_t b = a + 1; b < actors.size(); ++b)
      if (actors[a].morph && actors[b].morph && set[a] != set[b])
        ways.emplace_back(quantized(std::sqrt(trees[a][side]->nearly_closest(*trees[b][side]).squared)), a, b);
  std::sort(ways.begin(), ways.end());
  std::vector<std::array<std::size_t, 2>> result;
  for (const auto& [length, a, b] : ways) {
    if (set[a] == set[b]) continue;
    std::replace(set.begin(), set.end(), std::max(set[a], set[b]), std::min(set[a], set[b]));
    result.push_back({a, b});
  }
  return result;
}

} // namespace internal
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_INTERNAL_BLEND_BLEND_CAST_H

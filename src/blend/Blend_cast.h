// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_BLEND_BLEND_CAST_H
#define CGAL_SHAPE_CORRESPONDENCE_BLEND_BLEND_CAST_H

#include "base/quarter_turn.h"
#include "blend/Blend_links.h"
#include "blend/Morphing_cast.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

/// Where a fading part hangs on another actor.
struct Blend_attachment
{
  std::size_t actor;
  int surface;
  Mesh_place place;
  Point at;       ///< at the end that has the fading part
  Point vanished; ///< at the other end, but for how what it hangs on may be stretched
};

/// Leaves out places to hang on that go far apart though they are near each other on the part, those first that do so
/// most: what is there hangs together by other ways at the other end. Mirror images go together; one is always left.
/// \param size of the part
inline std::vector<Blend_attachment> kept_together(std::vector<Blend_attachment> holds, double size)
{
  constexpr double most_stretch = 3, near = 0.1; // the latter over the size
  for (;;) {
    std::vector<double> strains;
    for (const Blend_attachment& hold : holds) {
      double excess = 0;
      for (const Blend_attachment& other : holds) {
        const double before = std::max((hold.at - other.at).norm(), near * size);
        excess += std::max(0., (hold.vanished - other.vanished).norm() - most_stretch * before);
      }
      strains.push_back(excess * (hold.vanished - hold.at).norm());
    }
    const long worst = strains.empty() ? 0 : quantized(*std::max_element(strains.begin(), strains.end()));
    std::vector<Blend_attachment> kept;
    for (std::size_t i = 0; i < holds.size(); ++i)
      if (quantized(strains[i]) < worst) kept.push_back(holds[i]);
    if (worst == 0 || kept.empty()) return holds;
    holds = std::move(kept);
  }
}

/// The parts of a blend and how they hang together, in the common frame of both shapes.
class Blend_cast
{
public:
  using Tree = contacts::Triangle_tree;

  Blend_cast(const Blend_side& source, const Blend_side& target, const Correspondence& correspondence,
             double contact_tolerance);

  std::array<Segmented_shape, 2> shapes; ///< of the ends, as they were given
  std::array<Shape_frame, 2> frames;     ///< turned so that both shapes look alike
  Blend_ends ends;
  std::array<double, 2> apart = {0, 0}; ///< the widest gap that it takes to join all parts
  bool mirror = false;                  ///< both shapes have the mirror plane x = 0
  std::vector<Blend_actor> actors;
  std::vector<std::vector<Blend_attachment>> attachments; ///< by actor
  std::vector<Blend_link> links;
  std::vector<std::array<std::optional<Tree>, 2>> trees; ///< by actor and surface, at an end; to be moved
  std::vector<double> sizes;                             ///< by actor, the larger one of its surfaces'

  const Eigen::Matrix3Xi& triangles(std::size_t actor, int surface) const
  {
    return actors[actor].morph ? actors[actor].morph->triangles(surface) : actors[actor].fading->triangles();
  }

private:
  enum class Placed : char { NO, NEXT, YES };

  void add_end(const Blend_side& given, std::size_t side);
  void add_fading(const Blend_side& given, int side);
  void add_fading(const Blend_side& given, int side, std::size_t part, const std::vector<Placed>& placed);
  std::vector<Blend_attachment> holds_of(const Blend_side& given, int side, std::size_t part,
                                         const std::vector<Placed>& placed) const;
  std::vector<Blend_attachment> images_of(const std::vector<Blend_attachment>& holds, int side) const;
  Blend_attachment attachment(const std::vector<std::size_t>& candidates, int side, const Point& at) const;
  Points end_points(std::size_t actor, int side) const;
  Point vanished(const Blend_attachment& hold, int side) const;
  void add_trees();
};

inline Blend_cast::Blend_cast(const Blend_side& source, const Blend_side& target, const Correspondence& correspondence,
                              double contact_tolerance)
    : shapes{source.shape, target.shape}
{
  add_end(source, 0);
  add_end(target, 1);
  const auto is_mirrored_in_x = [](const Blend_side& side) {
    const Shape_frame& frame = structure(side.graph).frame;
    return side.quarter_turns % 2 == 0 ? frame.mirror_x : frame.mirror_z;
  };
  mirror = is_mirrored_in_x(source) && is_mirrored_in_x(target);
  for (std::size_t side : {0u, 1u}) {
    if (mirror) ends.twins[side] = Mirror_twins(ends.meshes[side]);
    mirror_charts(ends.meshes[side], ends.twins[side], ends.charted[side].charts);
  }
  actors = Morphing_cast(ends, correspondence).actors();
  attachments.resize(actors.size());
  add_fading(source, 0);
  add_fading(target, 1);
  add_trees();
  links = Link_finder(actors, trees, contact_tolerance, apart)({source, target});
}

inline void Blend_cast::add_end(const Blend_side& given, std::size_t side)
{
  std::vector<const Points*> surfaces;
  for (const Shape_part& part : given.shape.parts())
    surfaces.push_back(&part.mesh.points);
  ends.charted[side] = charted_shape(given.graph, given.quarter_turns, surfaces);
  ends.ground[side] = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const Points& points = ends.charted[side].surfaces[i];
    ends.meshes[side].push_back({points, given.shape.parts()[i].mesh.triangles});
    ends.ground[side] = std::min(ends.ground[side], points.row(1).minCoeff());
  }
  apart[side] = widest_gap(trees_of(ends.meshes[side]));
  frames[side] = structure(given.graph).frame;
  frames[side].axes = frames[side].axes * quarter_turn(given.quarter_turns).transpose();
}

inline Points Blend_cast::end_points(std::size_t actor, int side) const
{
  return actors[actor].morph ? actors[actor].points(side, side) : actors[actor].points_left(1);
}

/// Where a place to hang on is at the end that does not have what hangs there.
/// \param side the other one
inline Point Blend_cast::vanished(const Blend_attachment& hold, int side) const
{
  const Blend_actor& actor = actors[hold.actor];
  if (actor.morph) return hold.place.of(actor.points(hold.surface, 1 - side), triangles(hold.actor, hold.surface));
  Point result = actor.place(hold.at, 0);
  for (const Blend_attachment& on : attachments[hold.actor])
    result += (on.vanished - on.at) / double(attachments[hold.actor].size());
  return result;
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
    best = {actor, surface, place, p, p};
  }
  best.vanished = vanished(best, side);
  return best;
}

/// Where a part touches those that are placed.
inline std::vector<Blend_attachment> Blend_cast::holds_of(const Blend_side& given, int side, std::size_t part,
                                                          const std::vector<Placed>& placed) const
{
  const Shape_structure& shape = structure(given.graph);
  std::vector<Blend_attachment> result;
  const auto attach = [&](std::size_t other, const Eigen::Vector2d& parameter) {
    const Point place = to_common_frame(shape.frame, given.quarter_turns, evaluate(shape.parts[part], parameter));
    result.push_back(attachment(actors_of(actors, side, other), side, place));
  };
  for (const Contact& contact : shape.contacts)
    for (std::size_t i : {0u, 1u}) {
      if (contact.parts[i] != part || placed[contact.parts[1 - i]] != Placed::YES) continue;
      attach(contact.parts[1 - i], contact.parameters[i]);
      for (const Contact::Parameters& further : contact.further)
        attach(contact.parts[1 - i], further[i]);
    }
  return result;
}

/// The same on the other side of the mirror plane, as far as there is something to hold on to.
inline std::vector<Blend_attachment> Blend_cast::images_of(const std::vector<Blend_attachment>& holds, int side) const
{
  std::vector<Blend_attachment> result;
  for (const Blend_attachment& hold : holds)
    if (actors[hold.actor].twin != Mirror_twins::none)
      result.push_back(attachment({actors[hold.actor].twin}, side, mirrored(hold.at)));
  return result;
}

inline void Blend_cast::add_fading(const Blend_side& given, int side, std::size_t part,
                                   const std::vector<Placed>& placed)
{
  const std::size_t twin = ends.twins[std::size_t(side)][part];
  Blend_actor actor;
  const std::string& name = structure(given.graph).parts[part].name;
  actor.name = side == 0 ? name + '~' : '~' + name;
  actor.task.type = side == 0 ? Blend_task_type::SHRINK : Blend_task_type::GROW;
  (side == 0 ? actor.task.source : actor.task.target) = part;
  std::vector<Blend_attachment> holds = holds_of(given, side, part, placed);
  if (twin == part) {
    actor.twin = actors.size();
    const std::vector<Blend_attachment> images = images_of(holds, side);
    holds.insert(holds.end(), images.begin(), images.end());
  } else if (twin != Mirror_twins::none) {
    const std::vector<std::size_t> image = actors_of(actors, side, twin);
    if (!image.empty() && actors[image[0]].fading) {
      actor.twin = image[0];
      actors[image[0]].twin = actors.size();
      const std::vector<Blend_attachment> images = images_of(attachments[image[0]], side);
      actor.is_image = images.size() == attachments[image[0]].size();
      if (actor.is_image) holds = images;
    }
  }
  Part_mesh mesh = ends.meshes[std::size_t(side)][part];
  const double size = (mesh.points.rowwise().maxCoeff() - mesh.points.rowwise().minCoeff()).norm();
  holds = kept_together(std::move(holds), size);
  if (actor.is_image) mesh.points = mirrored(std::move(mesh.points));
  std::vector<Point> anchors;
  for (const Blend_attachment& hold : holds)
    anchors.push_back(actor.is_image ? mirrored(hold.at) : hold.at);
  actor.height = mesh.points.row(1).mean();
  actor.fading.emplace(ends.charted[std::size_t(side)].charts[actor.is_image ? twin : part], mesh, anchors);
  actors.push_back(std::move(actor));
  attachments.push_back(std::move(holds));
}

/// Parts without counterpart, in layers: what touches matched parts first, then what touches that.
inline void Blend_cast::add_fading(const Blend_side& given, int side)
{
  const Shape_structure& shape = structure(given.graph);
  std::vector<Placed> placed(shape.parts.size(), Placed::NO);
  for (std::size_t part = 0; part < placed.size(); ++part)
    if (!actors_of(actors, side, part).empty()) placed[part] = Placed::YES;
  for (bool any = true; any;) {
    any = false;
    for (const Contact& contact : shape.contacts)
      for (std::size_t i : {0u, 1u})
        if (placed[contact.parts[1 - i]] == Placed::YES && placed[contact.parts[i]] == Placed::NO)
          placed[contact.parts[i]] = Placed::NEXT;
    for (std::size_t part = 0; part < placed.size(); ++part)
      if (placed[part] == Placed::NEXT) add_fading(given, side, part, placed), any = true;
    std::replace(placed.begin(), placed.end(), Placed::NEXT, Placed::YES);
  }
  for (std::size_t part = 0; part < placed.size(); ++part)
    if (placed[part] == Placed::NO) add_fading(given, side, part, placed);
}

inline void Blend_cast::add_trees()
{
  constexpr double least = 1e-6;
  trees.resize(actors.size());
  sizes.resize(actors.size(), least);
  for (std::size_t a = 0; a < actors.size(); ++a)
    for (int side : {0, 1}) {
      if (actors[a].fading && actors[a].side() != side) continue;
      const int surface = actors[a].morph ? side : 0;
      std::optional<Tree>& tree = trees[a][std::size_t(surface)];
      tree = tree_of(end_points(a, side), triangles(a, surface));
      sizes[a] = std::max(sizes[a], tree->box().diagonal().norm());
    }
}

} // namespace internal
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_BLEND_BLEND_CAST_H

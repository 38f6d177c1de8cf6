// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_BLEND_BLEND_LINKS_H
#define CGAL_SHAPE_CORRESPONDENCE_BLEND_BLEND_LINKS_H

#include "blend/Blend_actor.h"
#include "blend/joining_ways.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

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

/// Finds the links of a blend: contacts of both ends, and of either end as many more as it takes to join what they
/// leave apart, those first that come apart least; then bridges, the shortest first. What is linked is linked alike on
/// both sides of the mirror plane.
class Link_finder
{
public:
  using Tree = contacts::Triangle_tree;
  using Pair = std::array<std::size_t, 2>; ///< of actors, the smaller one first

  /// \param trees by actor and end
  /// \param tolerance what is nearer than this touches
  /// \param apart by end, the widest gap that it takes to join all parts
  Link_finder(const std::vector<Blend_actor>& actors, const std::vector<std::array<std::optional<Tree>, 2>>& trees,
              double tolerance, const std::array<double, 2>& apart)
      : actors_(actors), trees_(trees), tolerance_(tolerance), apart_(apart)
  {}

  std::vector<Blend_link> operator()(const std::array<Blend_side, 2>& sides)
  {
    find_links(sides);
    for (const Blend_link& link : found_)
      if (link.touch[0] && link.touch[1]) keep(link);
    for (std::size_t side : {0u, 1u})
      join(side);
    std::vector<Blend_link> result;
    for (const auto& [pair, link] : kept_)
      result.push_back(link);
    return result;
  }

private:
  static Pair ordered(std::size_t a, std::size_t b) { return {std::min(a, b), std::max(a, b)}; }

  /// The pair on the other side of the mirror plane.
  std::optional<Pair> image(const Pair& pair) const
  {
    const std::size_t a = actors_[pair[0]].twin, b = actors_[pair[1]].twin;
    if (a == Mirror_twins::none || b == Mirror_twins::none || a == b) return std::nullopt;
    return ordered(a, b);
  }

  using Candidates = std::map<Pair, std::array<bool, 2>>; ///< whether the graph of an end has a contact

  void add_candidates(const Blend_side& given, int side, Candidates& candidates) const
  {
    const Shape_structure& shape = structure(given.graph);
    const auto add = [&](std::size_t part, std::size_t other) {
      const auto first = actors_of(actors_, side, part), second = actors_of(actors_, side, other);
      const bool of_whole_parts = part != other && first.size() == 1 && second.size() == 1;
      for (std::size_t a : first)
        for (std::size_t b : second)
          if (a != b && actors_[a].morph && actors_[b].morph)
            candidates[ordered(a, b)][std::size_t(side)] |= of_whole_parts;
    };
    for (const Contact& contact : shape.contacts)
      add(contact.parts[0], contact.parts[1]);
    for (std::size_t part = 0; part < shape.parts.size(); ++part)
      add(part, part);
  }

  /// Pairs that touch at an end, those first that come apart least.
  void find_links(const std::array<Blend_side, 2>& sides)
  {
    Candidates candidates;
    for (int side : {0, 1})
      add_candidates(sides[std::size_t(side)], side, candidates);
    std::map<Pair, Blend_link> links;
    for (const auto& [pair, contact] : candidates) {
      const auto link = links.emplace(pair, link_of(pair)).first;
      for (std::size_t side : {0u, 1u})
        link->second.touch[side] = link->second.touch[side] || contact[side];
    }
    for (const auto& [pair, contact] : candidates) {
      const std::optional<Pair> twin = image(pair);
      if (!twin) continue;
      Blend_link &own = links.at(pair), &other = links.emplace(*twin, link_of(*twin)).first->second;
      for (std::size_t side : {0u, 1u})
        own.touch[side] = other.touch[side] = own.touch[side] || other.touch[side];
    }
    for (const auto& [pair, link] : links)
      if (link.touch[0] || link.touch[1]) found_.push_back(link);
    const auto width = [](const Blend_link& link) { return quantized(std::max(link.gap[0], link.gap[1])); };
    std::stable_sort(found_.begin(), found_.end(),
                     [&](const Blend_link& a, const Blend_link& b) { return width(a) < width(b); });
  }

  Blend_link link_of(const Pair& pair) const
  {
    Blend_link link;
    link.actors = pair;
    for (std::size_t side : {0u, 1u}) {
      link.gap[side] = std::sqrt(trees_[pair[0]][side]->nearly_closest(*trees_[pair[1]][side]).squared);
      link.touch[side] = link.gap[side] <= tolerance_;
    }
    return link;
  }

  void keep(const Blend_link& link)
  {
    kept_.emplace(link.actors, link);
    const std::optional<Pair> twin = image(link.actors);
    if (!twin || kept_.count(*twin)) return;
    Blend_link other = link_of(*twin);
    other.touch = link.touch;
    kept_.emplace(*twin, other);
  }

  /// Keeps more until all that stays is joined at an end.
  void join(std::size_t side)
  {
    const double joined = std::max(tolerance_, apart_[side]);
    Disjoint_sets sets(actors_.size());
    for (const auto& [pair, link] : kept_)
      if (link.gap[side] <= joined) sets.unite(pair[0], pair[1]);
    for (const Blend_link& link : found_)
      if (link.gap[side] <= joined && sets.unite(link.actors[0], link.actors[1])) keep(link);
    for (const Pair& pair : bridges(side, sets))
      keep(link_of(pair));
  }

  /// The shortest ways between sets of actors that stay, at an end, as many as join all.
  std::vector<Pair> bridges(std::size_t side, const Disjoint_sets& sets) const
  {
    std::vector<std::size_t> stay;
    std::vector<const Tree*> surfaces;
    for (std::size_t a = 0; a < actors_.size(); ++a) {
      if (!actors_[a].morph) continue;
      stay.push_back(a);
      surfaces.push_back(&*trees_[a][side]);
    }
    Disjoint_sets own_sets(stay.size());
    for (std::size_t i = 0; i < stay.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (sets[stay[i]] == sets[stay[j]]) own_sets.unite(i, j);
    std::vector<Pair> result;
    for (const Joining_way& way : joining_ways(surfaces, own_sets))
      result.push_back({stay[way.surfaces[0]], stay[way.surfaces[1]]});
    return result;
  }

  const std::vector<Blend_actor>& actors_;
  const std::vector<std::array<std::optional<Tree>, 2>>& trees_;
  double tolerance_;
  std::array<double, 2> apart_;
  std::vector<Blend_link> found_;
  std::map<Pair, Blend_link> kept_;
};

} // namespace internal
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_BLEND_BLEND_LINKS_H

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Unmatched_chain.h"

#include "base/Disjoint_sets.h"
#include "blend/Blend_stage.h"

#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <map>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::internal {
namespace {

/// A chain, and where it touches matched parts.
struct Held_chain
{
  Unmatched_chain chain;
  contacts::Box box;
  std::vector<Point> places;
};

/// The middle of the places where a chain is held, or of its foot if it touches no matched part.
Point root_of(const Held_chain& held)
{
  const contacts::Box& box = held.box;
  if (held.places.empty()) return {box.center().x(), box.min().y(), box.center().z()};
  Point sum = Point::Zero();
  for (const Point& place : held.places)
    sum += place;
  return sum / double(held.places.size());
}

} // namespace

std::vector<Unmatched_chain> unmatched_chains(const Blend_stage& stage, const std::vector<Blend_part>& parts,
                                              const std::vector<Touch>& touches)
{
  Disjoint_sets joined(parts.size());
  for (const auto& [pair, gaps] : touches)
    if (!parts[pair[0]].is_matched() && !parts[pair[1]].is_matched()) joined.unite(pair[0], pair[1]);
  std::map<std::pair<int, std::size_t>, Held_chain> found; // by end and set
  for (std::size_t part = 0; part < parts.size(); ++part) {
    if (parts[part].is_matched()) continue;
    Held_chain& held = found[{parts[part].end(), joined[part]}];
    held.chain.end = parts[part].end();
    held.chain.parts.push_back(part);
    held.box.extend(parts[part].trees[0].box());
  }
  for (int end : {0, 1})
    for (const Contact& contact : structure(stage.graphs[std::size_t(end)]).contacts)
      for (std::size_t i : {0u, 1u}) {
        const std::size_t part = parts_of(parts, end, contact.parts[i]).front(), holds = contact.parts[1 - i];
        if (parts[part].is_matched() || !parts[parts_of(parts, end, holds).front()].is_matched()) continue;
        for (const Point& place : stage.places_of(end, contact)) {
          std::size_t triangle = 0;
          const Blend_part& piece = parts[nearest_piece(parts, end, holds, place)];
          found.at({end, joined[part]}).places.push_back(piece.end_tree(end).nearest(place, triangle));
        }
      }
  std::vector<Unmatched_chain> result;
  for (auto& [key, held] : found) {
    held.chain.root = root_of(held);
    result.push_back(std::move(held.chain));
  }
  return result;
}

} // namespace CGAL::Shape_correspondence::internal

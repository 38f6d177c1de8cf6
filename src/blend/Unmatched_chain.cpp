// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Unmatched_chain.h"

#include "base/Disjoint_sets.h"
#include "blend/Blend_stage.h"

#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::internal {
namespace {

/// The point of the nearest of the pieces of a part.
Point point_on(const std::vector<Blend_part>& parts, int end, std::size_t given, const Point& place)
{
  Point result = place;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t piece : parts_of(parts, end, given)) {
    std::size_t triangle = 0;
    const Point at = parts[piece].end_tree(end).nearest(place, triangle);
    if ((at - place).norm() < least) least = (at - place).norm(), result = at;
  }
  return result;
}

/// A chain, and where it touches matched parts.
struct Held_chain
{
  Unmatched_chain chain;
  std::vector<Point> places;
};

/// The middle of the places where a chain is held, or of its foot if it touches no matched part.
Point root_of(const Held_chain& held)
{
  const contacts::Box& box = held.chain.box;
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
    Unmatched_chain& chain = found[{parts[part].end(), joined[part]}].chain;
    chain.end = parts[part].end();
    chain.parts.push_back(part);
    chain.box.extend(parts[part].trees[0].box());
  }
  for (int end : {0, 1})
    for (const Contact& contact : structure(stage.graphs[std::size_t(end)]).contacts)
      for (std::size_t i : {0u, 1u}) {
        const std::size_t part = parts_of(parts, end, contact.parts[i]).front(), holds = contact.parts[1 - i];
        if (parts[part].is_matched() || !parts[parts_of(parts, end, holds).front()].is_matched()) continue;
        for (const Point& place : stage.places_of(end, contact))
          found.at({end, joined[part]}).places.push_back(point_on(parts, end, holds, place));
      }
  std::vector<Unmatched_chain> result;
  for (auto& [key, held] : found) {
    held.chain.root = root_of(held);
    result.push_back(std::move(held.chain));
  }
  return result;
}

} // namespace CGAL::Shape_correspondence::internal

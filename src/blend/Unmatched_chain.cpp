// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Unmatched_chain.h"

#include "base/Disjoint_sets.h"
#include "blend/Blend_stage.h"

#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

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

/// Where a chain is held: the middle of the places where it touches matched parts, or of its foot if it touches none.
Point root_of(const Unmatched_chain& chain, const Blend_stage& stage, const std::vector<Blend_part>& parts)
{
  Point sum = Point::Zero();
  double count = 0;
  const auto is_of_chain = [&](std::size_t given) {
    const std::size_t part = parts_of(parts, chain.end, given).front();
    return std::find(chain.parts.begin(), chain.parts.end(), part) != chain.parts.end();
  };
  const auto is_matched = [&](std::size_t given) {
    return parts[parts_of(parts, chain.end, given).front()].is_matched();
  };
  for (const Contact& contact : structure(stage.graphs[std::size_t(chain.end)]).contacts) {
    for (std::size_t i : {0u, 1u}) {
      const std::size_t held = contact.parts[i], holds = contact.parts[1 - i];
      if (!is_of_chain(held) || !is_matched(holds)) continue;
      for (const Point& place : stage.places_of(chain.end, contact)) {
        sum += point_on(parts, chain.end, holds, place);
        ++count;
      }
    }
  }
  if (count > 0) return sum / count;
  return {chain.box.center().x(), chain.box.min().y(), chain.box.center().z()};
}

} // namespace

std::vector<Unmatched_chain> unmatched_chains(const Blend_stage& stage, const std::vector<Blend_part>& parts,
                                              const std::vector<Touch>& touches)
{
  Disjoint_sets joined(parts.size());
  for (const auto& [pair, gaps] : touches)
    if (!parts[pair[0]].is_matched() && !parts[pair[1]].is_matched()) joined.unite(pair[0], pair[1]);
  std::map<std::pair<int, std::size_t>, Unmatched_chain> found; // by end and set
  for (std::size_t part = 0; part < parts.size(); ++part) {
    if (parts[part].is_matched()) continue;
    Unmatched_chain& chain = found[{parts[part].end(), joined[part]}];
    chain.end = parts[part].end();
    chain.parts.push_back(part);
    chain.box.extend(parts[part].trees[0].box());
  }
  std::vector<Unmatched_chain> result;
  for (auto& [key, chain] : found) {
    chain.root = root_of(chain, stage, parts);
    result.push_back(std::move(chain));
  }
  return result;
}

} // namespace CGAL::Shape_correspondence::internal

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Unmatched_chain.h"

#include "blend/Blend_stage.h"
#include "blend/Blend_structure.h"

#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <limits>
#include <map>
#include <utility>

namespace CGAL::Shape_correspondence::internal {
namespace {

/// Finds chains: what bodies have at an end, and other parts that touch each other.
class Chain_finder
{
public:
  Chain_finder(const Blend_stage& stage, const Blend_structure& blend, const Exchanged_bodies& bodies)
      : stage_(stage), parts_(blend.parts), bodies_(bodies), joined_(blend.parts.size())
  {
    std::map<std::pair<std::size_t, int>, std::size_t> first; // part of a body at an end
    for (std::size_t part = 0; part < parts_.size(); ++part)
      if (const std::size_t body = bodies.of(part); body != bodies.none)
        joined_.unite(part, first.try_emplace({body, parts_[part].end()}, part).first->second);
    for (const Touch& touch : blend.touches)
      if (is_loose(touch.parts[0]) && is_loose(touch.parts[1])) joined_.unite(touch.parts[0], touch.parts[1]);
  }

  /// The chains of a body, first that of the source; or, if it is none, all the others.
  std::vector<Unmatched_chain> chains(std::size_t body) const
  {
    std::map<std::pair<int, std::size_t>, Unmatched_chain> found; // by end and set
    for (std::size_t part = 0; part < parts_.size(); ++part) {
      if (parts_[part].is_matched() || bodies_.of(part) != body) continue;
      Unmatched_chain& chain = found[{parts_[part].end(), joined_[part]}];
      chain.parts.push_back(part);
      chain.box.extend(parts_[part].trees[0].box());
    }
    std::vector<Unmatched_chain> result;
    for (auto& [key, chain] : found) {
      chain.end = key.first;
      chain.body = body;
      if (chain.is_body()) chain.other_box = bodies_.boxes(body)[std::size_t(1 - chain.end)];
      chain.anchors = anchors(chain, key.second);
      chain.root = root_of(chain);
      result.push_back(std::move(chain));
    }
    return result;
  }

private:
  bool is_loose(std::size_t part) const { return !parts_[part].is_matched() && bodies_.of(part) == bodies_.none; }

  /// Where a chain touches matched parts and bodies that are placed before it.
  std::vector<Anchor> anchors(const Unmatched_chain& chain, std::size_t set) const
  {
    std::vector<Anchor> result;
    for (const Contact& contact : structure(stage_.graphs[std::size_t(chain.end)]).contacts)
      for (std::size_t i : {0u, 1u}) {
        const std::size_t part = parts_of(parts_, chain.end, contact.parts[i]).front();
        const auto carriers = parts_of(parts_, chain.end, contact.parts[1 - i]);
        if (parts_[part].is_matched() || joined_[part] != set) continue;
        if (parts_[carriers[0]].is_matched() || bodies_.of(carriers[0]) < chain.body)
          for (const Point& at : stage_.places_of(chain.end, contact))
            result.push_back(anchor(at, chain.end, carriers));
      }
    return result;
  }

  /// On the surface of the nearest of the pieces of a part.
  Anchor anchor(const Point& place, int end, const std::vector<std::size_t>& pieces) const
  {
    Anchor result;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t piece : pieces) {
      std::size_t triangle = 0;
      const Point at = parts_[piece].end_tree(end).nearest(place, triangle);
      const double distance = (at - place).norm();
      if (distance < least) least = distance, result.at = at, result.part = piece;
    }
    const Blend_part& part = parts_[result.part];
    result.body = bodies_.of(result.part);
    if (part.is_matched()) result.coordinates = part.morph->coordinates(end, result.at);
    return result;
  }

  /// Where a chain is held: the middle of its anchors, or of its foot if it has none.
  static Point root_of(const Unmatched_chain& chain)
  {
    if (chain.anchors.empty()) return {chain.box.center().x(), chain.box.min().y(), chain.box.center().z()};
    Point sum = Point::Zero();
    for (const Anchor& anchor : chain.anchors)
      sum += anchor.at;
    return sum / double(chain.anchors.size());
  }

  const Blend_stage& stage_;
  const std::vector<Blend_part>& parts_;
  const Exchanged_bodies& bodies_;
  Disjoint_sets joined_; ///< parts of one chain
};

} // namespace

std::vector<Unmatched_chain> unmatched_chains(const Blend_stage& stage, const Blend_structure& blend,
                                              const Exchanged_bodies& bodies)
{
  const Chain_finder finder(stage, blend, bodies);
  std::vector<Unmatched_chain> result;
  const auto add = [&](std::size_t body) {
    for (Unmatched_chain& chain : finder.chains(body))
      result.push_back(std::move(chain));
  };
  for (std::size_t body = 0; body < bodies.size(); ++body)
    add(body);
  add(bodies.none);
  return result;
}

} // namespace CGAL::Shape_correspondence::internal

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Unmatched_chain.h"

#include "base/Disjoint_sets.h"
#include "blend/Blend_stage.h"

#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <limits>
#include <map>
#include <utility>

namespace CGAL::Shape_correspondence::internal {
namespace {

/// Finds chains.
class Chain_finder
{
public:
  Chain_finder(const Blend_stage& stage, const std::vector<Blend_part>& parts, const std::vector<Touch>& touches)
      : stage_(stage), parts_(parts), joined_(parts.size())
  {
    for (const Touch& touch : touches)
      if (!parts[touch.parts[0]].is_matched() && !parts[touch.parts[1]].is_matched())
        joined_.unite(touch.parts[0], touch.parts[1]);
  }

  std::vector<Unmatched_chain> chains() const
  {
    std::map<std::pair<int, std::size_t>, Unmatched_chain> found; // by end and set
    for (std::size_t part = 0; part < parts_.size(); ++part) {
      if (parts_[part].is_matched()) continue;
      Unmatched_chain& chain = found[{parts_[part].end(), joined_[part]}];
      chain.parts.push_back(part);
      chain.box.extend(parts_[part].trees[0].box());
    }
    std::vector<Unmatched_chain> result;
    for (auto& [key, chain] : found) {
      chain.end = key.first;
      chain.anchors = anchors(chain.end, key.second);
      chain.root = root_of(chain);
      result.push_back(std::move(chain));
    }
    return result;
  }

private:
  /// Where a set of parts touches matched parts.
  std::vector<Anchor> anchors(int end, std::size_t set) const
  {
    std::vector<Anchor> result;
    for (const Contact& contact : structure(stage_.graphs[std::size_t(end)]).contacts)
      for (std::size_t i : {0u, 1u}) {
        const std::size_t part = parts_of(parts_, end, contact.parts[i]).front();
        const auto carriers = parts_of(parts_, end, contact.parts[1 - i]);
        if (parts_[part].is_matched() || joined_[part] != set || !parts_[carriers[0]].is_matched()) continue;
        for (const Point& at : stage_.places_of(end, contact))
          result.push_back(anchor(at, end, carriers));
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
    result.coordinates = parts_[result.part].morph->coordinates(end, result.at);
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
  Disjoint_sets joined_; ///< parts of one chain
};

} // namespace

std::vector<Unmatched_chain> unmatched_chains(const Blend_stage& stage, const std::vector<Blend_part>& parts,
                                              const std::vector<Touch>& touches)
{
  return Chain_finder(stage, parts, touches).chains();
}

} // namespace CGAL::Shape_correspondence::internal

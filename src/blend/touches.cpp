// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/touches.h"

#include "base/Disjoint_sets.h"
#include "blend/Blend_stage.h"

#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace CGAL::Shape_correspondence::internal {
namespace {

/// Unmatched parts that touch each other.
struct Chain
{
  contacts::Box box;
  Point sum = Point::Zero(); ///< of the places where matched parts hold it
  int places = 0;

  void add(const Point& place) { sum += place, ++places; }
  Point root() const
  {
    if (places > 0) return sum / places;
    return {box.center().x(), box.min().y(), box.center().z()};
  }
};

/// The middle of what two boxes that touch have in common, or of the gap between them.
Point middle_of_touch(const contacts::Box& a, const contacts::Box& b)
{
  return (a.min().cwiseMax(b.min()) + a.max().cwiseMin(b.max())) / 2;
}

} // namespace

std::vector<Touch> touches(const Blend_stage& stage, const std::vector<Blend_part>& parts, double tolerance)
{
  std::map<std::array<std::size_t, 2>, Touch> found; // by parts, the smaller index first
  for (int end : {0, 1})
    for (const Contact& contact : structure(stage.graphs[std::size_t(end)]).contacts) {
      const auto first = parts_of(parts, end, contact.parts[0]), second = parts_of(parts, end, contact.parts[1]);
      const bool are_whole = first.size() == 1 && second.size() == 1;
      for (std::size_t a : first)
        for (std::size_t b : second) {
          const double gap = std::sqrt(parts[a].end_tree(end).nearly_closest(parts[b].end_tree(end)).squared);
          const std::array<std::size_t, 2> pair = {std::min(a, b), std::max(a, b)};
          if (are_whole || gap <= tolerance)
            found.try_emplace(pair, Touch{pair}).first->second.gaps[std::size_t(end)] = gap;
        }
    }
  std::vector<Touch> result;
  for (const auto& [pair, touch] : found)
    result.push_back(touch);
  return result;
}

std::vector<Point> roots(const std::vector<Blend_part>& parts, const std::vector<Touch>& touches)
{
  Disjoint_sets sets(parts.size());
  for (const Touch& touch : touches)
    if (!parts[touch.parts[0]].is_matched() && !parts[touch.parts[1]].is_matched())
      sets.unite(touch.parts[0], touch.parts[1]);
  std::vector<Chain> chains(parts.size()); // by set
  for (std::size_t part = 0; part < parts.size(); ++part)
    chains[sets[part]].box.extend(parts[part].trees[0].box());
  for (const Touch& touch : touches)
    for (std::size_t i : {0u, 1u}) {
      const Blend_part &part = parts[touch.parts[i]], &holder = parts[touch.parts[1 - i]];
      if (part.is_matched() || !holder.is_matched()) continue;
      chains[sets[touch.parts[i]]].add(middle_of_touch(part.trees[0].box(), holder.end_tree(part.end()).box()));
    }
  std::vector<Point> result;
  for (std::size_t part = 0; part < parts.size(); ++part)
    result.push_back(chains[sets[part]].root());
  return result;
}

} // namespace CGAL::Shape_correspondence::internal

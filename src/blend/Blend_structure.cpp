// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Blend_structure.h"

#include "base/Disjoint_sets.h"

#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace CGAL::Shape_correspondence::internal {
namespace {

/// The pairs of parts whose given parts are in contact according to the graphs; of pieces, only those that are near.
std::vector<Touch> touches_of(const Blend_stage& stage, const std::vector<Blend_part>& parts, double tolerance)
{
  std::set<Touch> found; // the smaller index first
  for (int end : {0, 1})
    for (const Contact& contact : structure(stage.graphs[std::size_t(end)]).contacts) {
      const auto first = parts_of(parts, end, contact.parts[0]), second = parts_of(parts, end, contact.parts[1]);
      const bool are_whole = first.size() == 1 && second.size() == 1;
      for (std::size_t a : first)
        for (std::size_t b : second)
          if (are_whole ||
              std::sqrt(parts[a].end_tree(end).nearly_closest(parts[b].end_tree(end)).squared) <= tolerance)
            found.insert({std::min(a, b), std::max(a, b)});
    }
  return {found.begin(), found.end()};
}

/// For each unmatched part, the point to which it shrinks or from which it grows: for a set of unmatched parts that
/// touch each other, the mean of the places where matched parts touch it, or the foot of the set if there are none.
std::vector<Point> roots_of(const std::vector<Blend_part>& parts, const std::vector<Touch>& touches)
{
  Disjoint_sets sets(parts.size()); // connected sets of unmatched parts
  for (const Touch& touch : touches)
    if (!parts[touch[0]].is_matched() && !parts[touch[1]].is_matched()) sets.unite(touch[0], touch[1]);
  std::vector<contacts::Box> boxes(parts.size()); // bounding boxes of the sets
  // For each set, homogeneous sum of the places where matched parts touch it
  Eigen::Matrix4Xd places = Eigen::Matrix4Xd::Zero(4, parts.size());
  for (std::size_t part = 0; part < parts.size(); ++part)
    boxes[sets[part]].extend(parts[part].trees[0].box());
  for (const Touch& touch : touches)
    for (std::size_t i : {0u, 1u}) {
      const Blend_part &part = parts[touch[i]], &holder = parts[touch[1 - i]];
      if (part.is_matched() || !holder.is_matched()) continue;
      // The overlap of the boxes, or the gap between them
      const contacts::Box touched = part.trees[0].box().intersection(holder.end_tree(part.end()).box());
      places.col(Eigen::Index(sets[touch[i]])) += touched.center().homogeneous();
    }
  std::vector<Point> result;
  for (std::size_t part = 0; part < parts.size(); ++part) {
    const contacts::Box& box = boxes[sets[part]];
    const Eigen::Vector4d held = places.col(Eigen::Index(sets[part]));
    result.push_back(held[3] > 0 ? Point(held.hnormalized())
                                 : Point(box.center().x(), box.min().y(), box.center().z()));
  }
  return result;
}

} // namespace

Blend_structure::Blend_structure(const std::array<Blend_input, 2>& inputs, const Correspondence& correspondence,
                                 const Blend_options& options)
    : stage(inputs, options.size)
{
  parts = blend_parts(stage, correspondence, unlike);
  touches = touches_of(stage, parts, options.contact_tolerance);
  roots = roots_of(parts, touches);
  for (int end : {0, 1}) {
    std::vector<Seen_surface> seen;
    for (std::size_t i = 0; i < parts.size(); ++i)
      if (parts[i].is_at(end)) seen.emplace_back(parts, i, parts[i].end_surface(end), parts[i].end_points(end));
    supports[std::size_t(end)] = number_of_supports(seen);
    if (!seen.empty() && !seen.back().part.is_matched()) warps[std::size_t(end)].emplace(stage, parts, unlike, end);
  }
}

} // namespace CGAL::Shape_correspondence::internal

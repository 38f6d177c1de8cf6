// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Blend_structure.h"

#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace CGAL::Shape_correspondence::internal {
namespace {

/// The pairs of parts that stem from parts in contact in one of the graphs; of pieces, those within the tolerance.
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

bool stands(const Blend_part& part) { return part.trees[0].box().min().y() <= Blend_part::on_ground; }

/// The mean of the lowest points: the place where a part stands.
Point foot_of(const Points& points)
{
  const double lowest = points.row(1).minCoeff() + Blend_part::on_ground;
  Eigen::Vector4d sum = Eigen::Vector4d::Zero();
  for (const auto& p : points.colwise())
    if (p.y() <= lowest) sum += p.homogeneous();
  return sum.hnormalized();
}

/// Whether the part carries those that it touches, rather than being carried by them.
bool carries(const Blend_part& part)
{
  return part.is_matched() || part.task.obstacle != Blend_obstacle::NONE || stands(part);
}

std::vector<int> depths_of(const std::vector<Blend_part>& parts, const std::vector<Touch>& touches)
{
  const int unknown = int(parts.size());
  std::vector<int> result(parts.size(), unknown);
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (carries(parts[i])) result[i] = 0;
  for (bool is_new = true; is_new;) {
    is_new = false;
    for (const Touch& touch : touches)
      for (std::size_t i : {0u, 1u}) {
        int& depth = result[touch[i]];
        const int by_other = result[touch[1 - i]] + 1;
        if (by_other < depth) depth = by_other, is_new = true;
      }
  }
  for (int& depth : result)
    if (depth == unknown) depth = 1; // attached to nothing
  return result;
}

/// The middle of a contact, by boxes: their overlap, or the gap between them.
Point place_of(const std::vector<Blend_part>& parts, const Touch& touch, int end)
{
  return parts[touch[0]].end_tree(end).box().intersection(parts[touch[1]].end_tree(end).box()).center();
}

} // namespace

Blend_structure::Blend_structure(const std::array<Blend_input, 2>& inputs, const Correspondence& correspondence,
                                 const Blend_options& options)
    : stage(inputs, options.size)
{
  parts = blend_parts(stage, correspondence, unlike);
  motions.resize(parts.size());
  touches = touches_of(stage, parts, options.contact_tolerance);
  depths = depths_of(parts, touches);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    growths.emplace_back();
    if (!parts[i].is_matched()) growths[i].emplace(chart_of(i), parts[i].mesh.points, holds(i));
  }
  for (int end : {0, 1}) {
    std::vector<Seen_surface> seen;
    for (std::size_t i = 0; i < parts.size(); ++i)
      if (parts[i].is_at(end)) seen.emplace_back(parts, i, parts[i].end_surface(end), parts[i].end_points(end));
    supports[std::size_t(end)] = number_of_supports(seen);
    if (!seen.empty() && !seen.back().part.is_matched()) set_motions(end);
  }
}

/// Where an unmatched part touches others, or the ground.
Points Blend_structure::contacts(std::size_t unmatched) const
{
  const Blend_part& part = parts[unmatched];
  std::vector<Point> places;
  for (const Touch& touch : touches)
    if (touch[0] == unmatched || touch[1] == unmatched) places.push_back(place_of(parts, touch, part.end()));
  if (stands(part)) places.push_back(foot_of(part.mesh.points));
  Points result(3, Eigen::Index(places.size()));
  for (std::size_t i = 0; i < places.size(); ++i)
    result.col(Eigen::Index(i)) = places[i];
  return result;
}

/// Sets the warp of an end, and how its unmatched parts follow it.
void Blend_structure::set_motions(int end)
{
  constexpr double half_way = 0.5;
  const Space_warp& warp = warps[std::size_t(end)].emplace(stage, parts, unlike, end);
  std::vector<Points> surfaces;
  for (const Blend_part& part : parts)
    surfaces.push_back(part.is_matched() ? part.points(end, half_way) : Points());
  const Points ways = warp.ways(parts, surfaces, half_way);
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (!parts[i].is_matched() && parts[i].end() == end)
      motions[i].emplace(chart_of(i), contacts(i), stands(parts[i]), warp, ways);
}

const Part_chart& Blend_structure::chart_of(std::size_t unmatched) const
{
  const int end = parts[unmatched].end();
  return stage.charted[std::size_t(end)].charts[parts[unmatched].given(end)];
}

/// Where an unmatched part is held: by those that carry it or, if it carries others itself, by all that it touches.
std::vector<Point> Blend_structure::holds(std::size_t unmatched) const
{
  const Blend_part& part = parts[unmatched];
  std::vector<Point> result;
  for (const Touch& touch : touches) {
    if (touch[0] != unmatched && touch[1] != unmatched) continue;
    const std::size_t other = touch[touch[0] == unmatched ? 1 : 0];
    if (!parts[other].is_at(part.end()) || (depths[unmatched] > 0 && depths[other] >= depths[unmatched])) continue;
    result.push_back(place_of(parts, touch, part.end()));
  }
  if (stands(part) || result.empty()) result.push_back(foot_of(part.mesh.points));
  return result;
}

} // namespace CGAL::Shape_correspondence::internal

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Blend_structure.h"
#include "base/quantized.h"

#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

namespace CGAL::Shape_correspondence::internal {

Growth::Growth(const Part_chart& chart, const Points& points, const std::vector<Point>& holds)
    : chart_(chart), points_(points), coordinates_(3, points.cols()), offsets_(3, points.cols())
{
  constexpr double near = 0.25; // distance in the chart's coordinate along the axis, up to which two places become one
  // Limits of a half extent, over the height and over the half extent along the axis; if it is within both, the line
  // runs in the middle of the part
  constexpr double thin = 0.03, slender = 0.2;
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Point k = chart.coordinates(points.col(i));
    coordinates_.col(i) = k;
    offsets_.col(i) = chart.frame(k).inverse() * (points.col(i) - chart(k));
  }
  const Point half = chart.half_extents();
  Eigen::AlignedBox3d box;
  std::vector<Point> sorted;
  for (const Point& hold : holds) {
    sorted.push_back(chart.coordinates(hold));
    box.extend(sorted.back());
  }
  box.sizes().cwiseProduct(half).maxCoeff(&axis_);
  for (Point& station : sorted)
    for (int i = 0; i < 3; ++i)
      if (i != axis_ && half[i] <= std::min(thin, slender * half[axis_])) station[i] = 0;
  const auto key = [&](const Point& station) {
    const Point p = chart(station);
    return std::tuple(quantized(p.y()), quantized(p.z()));
  };
  std::sort(sorted.begin(), sorted.end(), [&](const Point& a, const Point& b) {
    return std::tuple(quantized(a[axis_]), key(a)) < std::tuple(quantized(b[axis_]), key(b));
  });
  for (const Point& station : sorted)
    if (stations_.empty() || station[axis_] - stations_.back()[axis_] > near)
      stations_.push_back(station);
    else if (key(station) < key(stations_.back()))
      stations_.back() = station;
    else if (!(key(stations_.back()) < key(station)))
      stations_.back() = (stations_.back() + station) / 2; // the two are mirror images
}

/// The place on the line from which the points at a coordinate along the axis grow.
Point Growth::from(double at) const
{
  const auto next =
      std::find_if(stations_.begin(), stations_.end(), [&](const Point& station) { return station[axis_] >= at; });
  if (next == stations_.begin()) return *next;
  const Point& last = *(next - 1);
  if (next == stations_.end()) return last;
  const double share = (at - last[axis_]) / ((*next)[axis_] - last[axis_]);
  return (1 - share) * last + share * *next;
}

Points Growth::points(double share) const
{
  constexpr double thick = 0.3; // share grown from which a part has its full thickness
  if (share >= 1) return points_;
  Points result(3, points_.cols());
  for (Eigen::Index i = 0; i < result.cols(); ++i) {
    const Point k = coordinates_.col(i), first = from(k[axis_]), now = first + share * (k - first);
    result.col(i) = chart_(now) + chart_.frame(now) * (std::min(1., share / thick) * offsets_.col(i));
  }
  return result;
}

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

/// Whether the part counts as carrying the parts that it touches: it morphs, corresponds, or stands on the ground.
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

/// The places from which an unmatched part grows: its contacts with parts of less depth or, if its depth is 0, with any
/// parts; and its foot, if it stands or has no such contact.
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

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Blend_structure.h"

#include "base/quantized.h"

#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

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

bool stands(const Blend_part& part) { return part.trees[0].box().min().y() <= Blend_part::on_ground; }

/// The mean of the lowest points.
Point foot_of(const Points& points)
{
  const double lowest = points.row(1).minCoeff() + Blend_part::on_ground;
  Eigen::Vector4d sum = Eigen::Vector4d::Zero();
  for (const auto& p : points.colwise())
    if (p.y() <= lowest) sum += p.homogeneous();
  return sum.hnormalized();
}

/// Whether others are carried by the part, and not it by them.
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
        const bool is_less = result[touch[1 - i]] + 1 < depth;
        if (is_less) depth = result[touch[1 - i]] + 1, is_new = true;
      }
  }
  for (int& depth : result)
    if (depth == unknown) depth = 1; // attached to nothing
  return result;
}

/// Where an unmatched part is held: by those that carry it or, if it carries others itself, by all that it touches.
std::vector<Point> places_of(const std::vector<Blend_part>& parts, const std::vector<Touch>& touches,
                             const std::vector<int>& depths, std::size_t number)
{
  const Blend_part& part = parts[number];
  std::vector<Point> result;
  for (const Touch& touch : touches) {
    if (touch[0] != number && touch[1] != number) continue;
    const std::size_t other = touch[0] == number ? touch[1] : touch[0];
    if (!parts[other].is_at(part.end())) continue;
    if (depths[number] == 0 || depths[other] < depths[number])
      // The overlap of the boxes, or the gap between them
      result.push_back(part.trees[0].box().intersection(parts[other].end_tree(part.end()).box()).center());
  }
  if (stands(part) || result.empty()) result.push_back(foot_of(part.mesh.points));
  return result;
}

} // namespace

Growth::Growth(const Part_chart& chart, const Points& points, const std::vector<Point>& places)
    : chart_(chart), points_(points), coordinates_(3, points.cols()), offsets_(3, points.cols())
{
  constexpr double near = 0.25; // distance along the axis, in coordinates, of places of which one stays
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Point k = chart.coordinates(points.col(i));
    coordinates_.col(i) = k;
    offsets_.col(i) = chart.frame(k).inverse() * (points.col(i) - chart(k));
  }
  contacts::Box box;
  std::vector<Point> sorted;
  for (const Point& place : places) {
    sorted.push_back(chart.coordinates(place));
    box.extend(sorted.back());
  }
  box.sizes().cwiseProduct(chart.half_extents()).maxCoeff(&axis_);
  const auto key = [&](const Point& k) {
    const Point p = chart(k);
    return std::tuple(quantized(p.y()), quantized(p.z()));
  };
  std::sort(sorted.begin(), sorted.end(), [&](const Point& a, const Point& b) {
    return std::tuple(quantized(a[axis_]), key(a)) < std::tuple(quantized(b[axis_]), key(b));
  });
  for (const Point& place : sorted)
    if (places_.empty() || place[axis_] - places_.back()[axis_] > near)
      places_.push_back(place);
    else if (key(place) < key(places_.back()))
      places_.back() = place;
    else if (!(key(places_.back()) < key(place)))
      places_.back() = (places_.back() + place) / 2; // mirror images
}

/// The point of the line through the places that is next to a point along the axis.
Point Growth::held(const Point& k) const
{
  const auto next = std::find_if(places_.begin(), places_.end(), [&](const Point& p) { return p[axis_] >= k[axis_]; });
  if (next == places_.begin()) return places_.front();
  if (next == places_.end()) return places_.back();
  const Point &a = *(next - 1), &b = *next;
  return a + (k[axis_] - a[axis_]) / (b[axis_] - a[axis_]) * (b - a);
}

Points Growth::points(double share) const
{
  if (share >= 1) return points_;
  Points result(3, points_.cols());
  for (Eigen::Index i = 0; i < result.cols(); ++i) {
    const Point k = coordinates_.col(i), from = held(k), now = from + share * (k - from);
    result.col(i) = chart_(now) + chart_.frame(now) * (share * offsets_.col(i));
  }
  return result;
}

Blend_structure::Blend_structure(const std::array<Blend_input, 2>& inputs, const Correspondence& correspondence,
                                 const Blend_options& options)
    : stage(inputs, options.size)
{
  parts = blend_parts(stage, correspondence, unlike);
  touches = touches_of(stage, parts, options.contact_tolerance);
  depths = depths_of(parts, touches);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    growths.emplace_back();
    if (parts[i].is_matched()) continue;
    const auto end = std::size_t(parts[i].end());
    growths[i].emplace(stage.charted[end].charts[parts[i].given(parts[i].end())], parts[i].mesh.points,
                       places_of(parts, touches, depths, i));
  }
  for (int end : {0, 1}) {
    std::vector<Seen_surface> seen;
    for (std::size_t i = 0; i < parts.size(); ++i)
      if (parts[i].is_at(end)) seen.emplace_back(parts, i, parts[i].end_surface(end), parts[i].end_points(end));
    supports[std::size_t(end)] = number_of_supports(seen);
    if (!seen.empty() && !seen.back().part.is_matched()) warps[std::size_t(end)].emplace(stage, parts, unlike, end);
  }
}

} // namespace CGAL::Shape_correspondence::internal

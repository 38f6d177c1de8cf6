// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/End_look.h"

#include <Eigen/Geometry>

#include <cmath>
#include <utility>

namespace CGAL::Shape_correspondence::internal {
namespace {

constexpr double least_depth = 0.003; // of the height: what is nearer to a surface is on it

/// Whether a point is inside, by the side of the nearest triangle that it is on; not where that is unclear.
bool is_inside(const Point& p, const Seen_surface& surface)
{
  constexpr double across = 0.7; // cosine of the angle between the normal and the way to the surface
  std::size_t triangle = 0;
  const Point way = surface.tree->nearest(p, triangle) - p;
  const double depth = way.norm();
  if (depth < least_depth) return false;
  const contacts::Triangle& nearest = surface.tree->triangles()[triangle];
  const Point normal = (nearest[1] - nearest[0]).cross(nearest[2] - nearest[0]);
  return (surface.looks_outwards ? 1 : -1) * normal.dot(way) > across * depth * normal.norm();
}

/// Whether a surface, which may be open, is in the way in six directions.
bool is_enclosed(const Point& p, const contacts::Triangle_tree& surface)
{
  if (!surface.box().contains(p)) return false;
  const Point tilt(0.011, 0.017, 0.013); // meshes have edges in planes of the coordinates
  for (int axis = 0; axis < 3; ++axis)
    for (double sign : {1., -1.})
      if (surface.crossings(p, sign * Point::Unit(axis) + tilt) == 0) return false;
  return true;
}

double share_inside(const Points& samples, const Seen_surface& surface)
{
  int inside = 0;
  for (Eigen::Index i = 0; i < samples.cols(); ++i)
    inside += surface.tree->box().contains(samples.col(i)) && is_inside(samples.col(i), surface);
  return samples.cols() > 0 ? double(inside) / double(samples.cols()) : 0;
}

} // namespace

double hidden_share(const Points& samples, const contacts::Triangle_tree& surface, bool is_on_hidden)
{
  int hidden = 0;
  for (Eigen::Index i = 0; i < samples.cols(); ++i)
    hidden += surface.is_near(samples.col(i), least_depth * least_depth) ? is_on_hidden
                                                                         : is_enclosed(samples.col(i), surface);
  return samples.cols() > 0 ? double(hidden) / double(samples.cols()) : 0;
}

Overlaps overlaps_of(const std::vector<Seen_surface>& surfaces)
{
  Overlaps result;
  for (const Seen_surface& b : surfaces) {
    if (!b.is_closed) continue;
    for (const Seen_surface& a : surfaces) {
      if (a.part == b.part || !a.tree->box().intersects(b.tree->box())) continue;
      if (const double share = share_inside(a.samples, b); share > 0) result[{a.part, b.part}] = share;
    }
  }
  return result;
}

End_look::End_look(const std::vector<Blend_part>& parts, int end)
{
  std::vector<Seen_surface> surfaces;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].unmatched && parts[i].end() != end) continue;
    const auto surface = std::size_t(parts[i].end_surface(end));
    const Rest_surface& rest = *parts[i].rests[surface];
    area += rest.extent().area;
    if (rest.is_closed()) volume += std::abs(rest.extent().volume);
    surfaces.push_back({i, rest.samples(parts[i].end_points(end)), &*parts[i].trees[surface], rest.is_closed(),
                        rest.extent().volume > 0});
  }
  overlaps = overlaps_of(surfaces);
}

} // namespace CGAL::Shape_correspondence::internal

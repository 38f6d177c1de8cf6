// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Blend_structure.h"

#include "blend/change_groups.h"
#include "blend/surface_components.h"
#include "blend/unlike_pairs.h"
#include "shape/convex_hull.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL::Shape_correspondence::internal {
namespace {

double end_asymmetry_of(const std::vector<Part_mesh>& meshes)
{
  std::vector<const Points*> surfaces;
  for (const Part_mesh& mesh : meshes)
    surfaces.push_back(&mesh.points);
  const std::vector<contacts::Triangle_tree> trees = trees_of(meshes);
  return mirror_residual(surfaces, pointers_to(trees));
}

constexpr double least_depth = 0.003; // of the height: what is nearer to a surface is on it

/// Whether a point is inside, by the side of the nearest triangle that it is on; not where that is unclear.
bool is_inside(const Point& p, const Seen_surface& surface)
{
  constexpr double across = 0.7; // cosine of the angle between the normal and the way to the surface
  std::size_t triangle = 0;
  const Point way = surface.tree->nearest(p, triangle) - p;
  const double depth = way.norm();
  if (depth < least_depth) return false;
  const Point normal = contacts::area_vector(surface.tree->triangles()[triangle]);
  return (surface.looks_outwards ? 1 : -1) * normal.dot(way) > across * depth * normal.norm();
}

double share_inside(const Points& samples, const Seen_surface& surface)
{
  int inside = 0;
  for (Eigen::Index i = 0; i < samples.cols(); ++i)
    inside += surface.tree->box().contains(samples.col(i)) && is_inside(samples.col(i), surface);
  return samples.cols() > 0 ? double(inside) / double(samples.cols()) : 0;
}

} // namespace

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

double hull_volume(const std::vector<const Points*>& surfaces)
{
  Eigen::Index count = 0;
  for (const Points* surface : surfaces)
    count += surface->cols();
  Points all(3, count);
  for (const Points* surface : surfaces) {
    count -= surface->cols();
    all.middleCols(count, surface->cols()) = *surface;
  }
  return all.cols() > 0 ? convex_hull(all).volume : 0;
}

End_look::End_look(const std::vector<Blend_part>& parts, int end)
{
  std::vector<Seen_surface> seen;
  std::vector<Points> points;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!parts[i].is_at(end)) continue;
    const auto surface = std::size_t(parts[i].end_surface(end));
    const Rest_surface& rest = parts[i].rests[surface];
    if (rest.is_closed()) volume += std::abs(rest.extent().volume);
    supports += parts[i].trees[surface].box().min().y() <= Blend_part::on_ground;
    points.push_back(parts[i].end_points(end));
    seen.push_back(
        {i, rest.samples(points.back()), &parts[i].trees[surface], rest.is_closed(), rest.extent().volume > 0});
  }
  overlaps = overlaps_of(seen);
  std::vector<const Points*> surfaces;
  for (const Points& surface : points)
    surfaces.push_back(&surface);
  hull = hull_volume(surfaces);
}

Blend_structure::Blend_structure(const std::array<Blend_input, 2>& inputs, const Correspondence& correspondence,
                                 const Blend_options& options)
    : Blend_structure(inputs, Blend_stage(inputs), correspondence, options)
{}

Blend_structure::Blend_structure(const std::array<Blend_input, 2>& inputs, const Blend_stage& stage,
                                 const Correspondence& correspondence, const Blend_options& options)
    : shapes(stage.moved_shapes(inputs, options.size)),
      is_symmetric(stage.are_symmetric),
      boxes(stage.boxes),
      widest_gap(stage.widest_gap),
      axes_(structure(inputs[0].graph).frame.axes),
      heights_(stage.heights(options.size))
{
  Unlike_pairs unlike;
  parts = matched_parts(stage, correspondence, unlike);
  for (Blend_part& part : unmatched_parts(stage, unlike, parts))
    parts.push_back(std::move(part));
  touches = internal::touches(stage, parts, options.contact_tolerance);
  chains = unmatched_chains(stage, parts, touches);
  for (const Unmatched_chain& chain : chains)
    if (auto& warp = warps[std::size_t(chain.end)]; !warp) warp.emplace(stage, parts, unlike.all, chain.end);
  groups = change_groups(stage, unlike.all, parts, touches);
  for (std::size_t end : {0u, 1u}) {
    looks.emplace_back(parts, int(end));
    if (is_symmetric) end_asymmetry[end] = end_asymmetry_of(stage.meshes[end]);
  }
}

Points Blend_structure::to_world(const Points& points, double done) const
{
  return axes_ * (std::pow(heights_[0], 1 - done) * std::pow(heights_[1], done)) * points;
}

} // namespace CGAL::Shape_correspondence::internal

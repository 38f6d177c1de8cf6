// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/End_look.h"

#include "base/eigen_system.h"
#include "shape/convex_hull.h"

#include <Eigen/Geometry>

#include <cmath>
#include <limits>
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
  constexpr int directions = 150;
  constexpr double flat = 1e-3; // of the height
  Eigen::Matrix<double, directions, 3> towards;
  for (int i = 0; i < directions; ++i) { // along a spiral from pole to pole
    const double z = (2. * i + 1) / directions - 1, r = std::sqrt(1 - z * z),
                 angle = i * double(EIGEN_PI) * (3 - std::sqrt(5.));
    towards.row(i) << r * std::cos(angle), z, r * std::sin(angle);
  }
  Points farthest(3, directions);
  Eigen::VectorXd most = Eigen::VectorXd::Constant(directions, -std::numeric_limits<double>::infinity());
  for (const Points* surface : surfaces) {
    const Eigen::MatrixXd along = towards * *surface;
    for (int i = 0; i < directions; ++i) {
      Eigen::Index at = 0;
      const double reach = along.row(i).maxCoeff(&at);
      if (reach > most[i]) most[i] = reach, farthest.col(i) = surface->col(at);
    }
  }
  if (surfaces.empty()) return 0;
  const Point middle = farthest.rowwise().mean();
  const Points centred = farthest.colwise() - middle;
  if (eigen_system(scatter_matrix(centred)).values[0] < directions * flat * flat) return 0;
  return convex_hull(farthest).volume;
}

End_look::End_look(const std::vector<Blend_part>& parts, int end)
{
  std::vector<Seen_surface> seen;
  std::vector<Points> points;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!parts[i].is_at(end)) continue;
    const auto surface = std::size_t(parts[i].end_surface(end));
    const Rest_surface& rest = parts[i].rests[surface];
    area += rest.extent().area;
    if (rest.is_closed()) volume += std::abs(rest.extent().volume);
    supports += parts[i].foot[std::size_t(end)] <= Blend_part::on_ground;
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

} // namespace CGAL::Shape_correspondence::internal

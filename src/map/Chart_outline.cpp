// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "map/Chart_outline.h"

#include "base/clamped.h"
#include "base/planar_hull.h"

#include <CGAL/assertions.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace CGAL::Shape_correspondence::internal {
namespace {

constexpr int outline_stations = 17;

/// Distance from the origin to the boundary of a convex polygon around it, in a direction.
double reach_in_polygon(const Planar_points& polygon, const Eigen::Vector2d& direction)
{
  double reach = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d& a = polygon[i];
    const Eigen::Vector2d side = polygon[(i + 1) % polygon.size()] - a;
    const double across = direction.x() * side.y() - direction.y() * side.x();
    if (std::abs(across) < 1e-12) continue;
    const double along = (a.x() * side.y() - a.y() * side.x()) / across;
    const double at = (a.x() * direction.y() - a.y() * direction.x()) / across;
    if (at >= -1e-9 && at <= 1 + 1e-9) reach = std::max(reach, along);
  }
  return reach;
}

} // namespace

Chart_outline::Section Chart_outline::section_around(const std::vector<Eigen::Vector2d>& points)
{
  constexpr double least_radius = 0.02; // ratio to the half extents; gives a section that is a point an outline
  // Ratio to the largest radius, which may lie between two sampled angles of a flat section
  constexpr double least_share = 0.3;
  Section result;
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& p : points)
    box.extend(p);
  result.middle = box.center();
  Planar_points centred;
  for (const Eigen::Vector2d& p : points)
    centred.push_back(p - result.middle);
  double largest = 0;
  for (const Eigen::Vector2d& p : centred)
    largest = std::max(largest, p.norm());
  const double least = std::max(least_radius, least_share * largest);
  const Planar_points hull = planar_hull(centred);
  for (int i = 0; i < angles; ++i) {
    const auto angle = double(2 * EIGEN_PI * i / angles);
    const Eigen::Vector2d direction(std::cos(angle), std::sin(angle));
    result.radii[i] = std::max(least, reach_in_polygon(hull, direction));
  }
  return result;
}

Chart_outline::Chart_outline(bool is_sheet, const Points& coordinates) : is_sheet_(is_sheet)
{
  constexpr double half_width = 0.2; // half the width of a section's slice, in chart coordinates
  const auto points_near = [&](double station, double width) {
    std::vector<Eigen::Vector2d> result;
    for (Eigen::Index i = 0; i < coordinates.cols(); ++i)
      if (is_sheet_ || std::abs(coordinates(0, i) - station) <= width)
        result.push_back(coordinates.col(i).segment<2>(first()));
    return result;
  };
  for (int i = 0; i < (is_sheet_ ? 1 : outline_stations); ++i) {
    const double station = 2. * i / (outline_stations - 1) - 1;
    std::vector<Eigen::Vector2d> points;
    for (double width = half_width; points.size() < 3 && width < 4; width *= 2)
      points = points_near(station, width);
    sections_.push_back(points.empty() ? Section() : section_around(points));
  }
}

Chart_outline::Section Chart_outline::section(const Point& k) const
{
  if (is_sheet_) return sections_[0];
  const double at = clamped_to_unit((k[0] + 1) / 2) * (outline_stations - 1);
  const int cell = clamped_cell(at, outline_stations - 2);
  const double share = at - cell;
  const Section &a = sections_[std::size_t(cell)], &b = sections_[std::size_t(cell + 1)];
  return {(1 - share) * a.middle + share * b.middle, (1 - share) * a.radii + share * b.radii};
}

double Chart_outline::radius(const Section& section, const Eigen::Vector2d& direction)
{
  const auto turn = double(std::atan2(direction.y(), direction.x()) / (2 * EIGEN_PI));
  const double at = (turn - std::floor(turn)) * angles;
  const int cell = clamped_cell(at, angles - 1);
  return (1 - (at - cell)) * section.radii[cell] + (at - cell) * section.radii[(cell + 1) % angles];
}

Point Chart_outline::relative(const Point& k) const
{
  if (sections_.empty()) return k;
  const Section at = section(k);
  Point result = k;
  const Eigen::Vector2d off = k.segment<2>(first()) - at.middle;
  result.segment<2>(first()) = off / radius(at, off);
  return result;
}

Point Chart_outline::absolute(const Point& q) const
{
  if (sections_.empty()) return q;
  const Section at = section(q);
  Point result = q;
  const Eigen::Vector2d off = q.segment<2>(first());
  result.segment<2>(first()) = at.middle + radius(at, off) * off;
  return result;
}

Chart_outline Chart_outline::between(const Chart_outline& a, const Chart_outline& b, double t)
{
  CGAL_precondition(a.is_sheet_ == b.is_sheet_);
  Chart_outline result = a;
  for (std::size_t i = 0; i < result.sections_.size(); ++i) {
    Section& section = result.sections_[i];
    section.middle = (1 - t) * a.sections_[i].middle + t * b.sections_[i].middle;
    section.radii = (1 - t) * a.sections_[i].radii + t * b.sections_[i].radii;
  }
  return result;
}

} // namespace CGAL::Shape_correspondence::internal

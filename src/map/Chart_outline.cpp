// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "map/Part_chart.h"

#include "base/clamped.h"
#include "base/planar_hull.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace CGAL::Shape_correspondence::internal {
namespace {

constexpr int stations = 33;           // number of cross-sections of an outline
constexpr double last_station = 0.998; // coordinate of the last one: inside of the end, where sections are not empty

double station(int i) { return -last_station * std::cos(double(EIGEN_PI * i / (stations - 1))); }

/// The two ends of each segment in which a triangle crosses the plane of a section.
std::vector<Eigen::Vector2d> crossed(const Points& coordinates, const Eigen::Matrix3Xi& triangles, double station)
{
  std::vector<Eigen::Vector2d> result;
  for (const auto& corners : triangles.colwise()) {
    int found = 0;
    for (int i = 0; i < 3 && found < 2; ++i) {
      const auto a = coordinates.col(corners[i]), b = coordinates.col(corners[(i + 1) % 3]);
      if ((a[0] < station) == (b[0] < station)) continue;
      const double share = (station - a[0]) / (b[0] - a[0]);
      result.emplace_back((1 - share) * a.tail<2>() + share * b.tail<2>());
      ++found;
    }
  }
  return result;
}

Eigen::Vector2d direction(int angle, int angles)
{
  const auto at = double(2 * EIGEN_PI * angle / angles);
  return {std::cos(at), std::sin(at)};
}

/// The angle of a direction, in steps between the angles of an outline.
double turn_of(const Eigen::Vector2d& direction, int angles)
{
  const auto turn = double(std::atan2(direction.y(), direction.x()) / (2 * EIGEN_PI));
  return (turn - std::floor(turn)) * angles;
}

} // namespace

/// Sets the outline of a section. \param segments the two ends of each segment \return whether there is an outline
bool Chart_outline::set_outline(Section& section, const std::vector<Eigen::Vector2d>& segments)
{
  constexpr double least_half = 1e-3, least_radius = 0.02; // lower bounds: a section may be a point
  if (segments.size() < 4) return false;
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& p : segments)
    box.extend(p);
  section.middle = box.center();
  section.half = (box.sizes() / 2).cwiseMax(least_half);
  const auto place = [&](std::size_t i) -> Eigen::Vector2d {
    return (segments[i] - section.middle).cwiseQuotient(section.half);
  };
  for (std::size_t i = 0; i + 1 < segments.size(); i += 2) {
    const Eigen::Vector2d a = place(i), side = place(i + 1) - a;
    double from = turn_of(a, angles), to = turn_of(a + side, angles);
    if (from > to) std::swap(from, to);
    if (to - from > angles / 2.) from += angles, std::swap(from, to); // the segment crosses the angle 0
    for (int at = int(std::ceil(from)); at <= to; ++at) {
      const Eigen::Vector2d along = direction(at % angles, angles);
      const double slope = cross(along, side);
      if (std::abs(slope) < 1e-12) continue;
      double& known = section.radii[at % angles];
      known = std::max(known, cross(a, side) / slope);
    }
  }
  for (std::size_t i = 0; i < segments.size(); ++i) { // flat sections have radii only at the angles of their ends
    const Eigen::Vector2d end = place(i);
    double& known = section.radii[int(std::lround(turn_of(end, angles))) % angles];
    if (known < least_radius) known = end.norm();
  }
  if (!(section.radii.array() > least_radius).any()) return false;
  const Radii found = section.radii;
  for (int i = 0; i < angles; ++i) { // interpolates radii at angles without a segment
    if (found[i] > least_radius) continue;
    int before = 1, after = 1;
    while (!(found[(i - before + angles) % angles] > least_radius))
      ++before;
    while (!(found[(i + after) % angles] > least_radius))
      ++after;
    section.radii[i] =
        (after * found[(i - before + angles) % angles] + before * found[(i + after) % angles]) / (before + after);
  }
  return true;
}

Chart_outline::Chart_outline() : sections_(stations)
{
  for (Section& section : sections_)
    section.radii.setOnes();
}

Chart_outline::Chart_outline(const Points& coordinates, const Eigen::Matrix3Xi& triangles) : Chart_outline()
{
  std::vector<int> known;
  for (int i = 0; i < stations; ++i) {
    Section section;
    if (!set_outline(section, crossed(coordinates, triangles, station(i)))) continue;
    sections_[std::size_t(i)] = section;
    known.push_back(i);
  }
  for (int i = 0; i < stations && !known.empty(); ++i) {
    const auto nearest =
        std::min_element(known.begin(), known.end(), [&](int a, int b) { return std::abs(a - i) < std::abs(b - i); });
    sections_[std::size_t(i)] = sections_[std::size_t(*nearest)];
  }
}

Chart_outline::Section Chart_outline::section(double k) const
{
  const auto turn = double(std::acos(std::clamp(-k / last_station, -1., 1.)) / EIGEN_PI);
  const double at = clamped_to_unit(turn) * (stations - 1);
  const int cell = clamped_cell(at, stations - 2);
  const double share = at - cell;
  const Section &a = sections_[std::size_t(cell)], &b = sections_[std::size_t(cell + 1)];
  return {(1 - share) * a.middle + share * b.middle, (1 - share) * a.half + share * b.half,
          (1 - share) * a.radii + share * b.radii};
}

double Chart_outline::radius(const Section& section, const Eigen::Vector2d& direction)
{
  const double at = turn_of(direction, angles);
  const int cell = clamped_cell(at, angles - 1);
  return (1 - (at - cell)) * section.radii[cell] + (at - cell) * section.radii[(cell + 1) % angles];
}

Point Chart_outline::relative(const Point& k) const
{
  const Section at = section(k[0]);
  const Eigen::Vector2d off = (k.tail<2>() - at.middle).cwiseQuotient(at.half), disc = off / radius(at, off);
  return {k[0], disc.x(), disc.y()};
}

Point Chart_outline::absolute(const Point& q) const
{
  const Section at = section(q[0]);
  const Eigen::Vector2d off = q.tail<2>(), place = at.middle + at.half.cwiseProduct(radius(at, off) * off);
  return {q[0], place.x(), place.y()};
}

Chart_outline Chart_outline::smoothed() const
{
  constexpr int along = 6, around = 2; // rounds in which each value is averaged with those beside it
  Chart_outline result = *this;
  for (int round = 0; round < along; ++round) {
    const std::vector<Section> last = result.sections_;
    for (std::size_t i = 0; i < last.size(); ++i) {
      const Section &before = last[i > 0 ? i - 1 : 0], &at = last[i], &after = last[std::min(i + 1, last.size() - 1)];
      result.sections_[i] = {(before.middle + 2 * at.middle + after.middle) / 4,
                             (before.half + 2 * at.half + after.half) / 4,
                             (before.radii + 2 * at.radii + after.radii) / 4};
    }
  }
  for (int round = 0; round < around; ++round)
    for (Section& section : result.sections_) {
      const Radii last = section.radii;
      for (int i = 0; i < angles; ++i)
        section.radii[i] = (last[(i + angles - 1) % angles] + 2 * last[i] + last[(i + 1) % angles]) / 4;
    }
  return result;
}

Chart_outline Chart_outline::between(const Chart_outline& a, const Chart_outline& b, double t)
{
  Chart_outline result = a;
  for (std::size_t i = 0; i < result.sections_.size(); ++i) {
    const Section &from = a.sections_[i], &to = b.sections_[i];
    result.sections_[i] = {(1 - t) * from.middle + t * to.middle, (1 - t) * from.half + t * to.half,
                           (1 - t) * from.radii + t * to.radii};
  }
  return result;
}

} // namespace CGAL::Shape_correspondence::internal

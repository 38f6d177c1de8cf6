// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "base/eigen_system.h"
#include "structure/Symmetry_candidate.h"

namespace CGAL::Shape_correspondence::internal {
namespace symmetry {

constexpr auto full_turn = double(2 * EIGEN_PI);
constexpr double uneven_angle = 0.15; ///< deviation of an angle between neighbours from the mean angle, over the mean
constexpr double star_core = 0.4;     ///< largest ratio of inner and outer radius of a star's members
constexpr double horizontal_limit = 0.1; ///< largest vertical component of an axis that counts as horizontal
/// Fewer members about a horizontal axis must be a star: a frame is no ring.
constexpr std::size_t least_horizontal_ring = 5;

struct Axis
{
  Point point;
  Point direction; ///< unit vector
};

/// Cylindrical coordinates of a part's centre about an axis.
struct Ring_place
{
  std::size_t part;
  double height, radius, angle;
};

inline std::vector<Ring_place> places_about(const Part_relations& parts, const std::vector<std::size_t>& candidates,
                                            const Axis& axis)
{
  Point zero = axis.direction.cross(Point::UnitX());
  if (zero.norm() < 0.5) zero = axis.direction.cross(Point::UnitZ());
  zero.normalize();
  const Point quarter = axis.direction.cross(zero);
  std::vector<Ring_place> result;
  for (std::size_t part : candidates) {
    const Point d = parts[part].centre - axis.point;
    const double x = d.dot(zero), y = d.dot(quarter);
    result.push_back({part, d.dot(axis.direction), std::hypot(x, y), std::atan2(y, x)});
  }
  std::sort(result.begin(), result.end(), [](const Ring_place& a, const Ring_place& b) { return a.angle < b.angle; });
  return result;
}

inline bool is_evenly_turned(const std::vector<Ring_place>& ring)
{
  const double even = full_turn / double(ring.size());
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const bool wraps = i + 1 == ring.size();
    const double angle = ring[wraps ? 0 : i + 1].angle - ring[i].angle + (wraps ? full_turn : 0);
    if (std::abs(angle - even) > uneven_angle * even) return false;
  }
  return true;
}

inline bool comes_from_axis(const Part_signature& part, const Axis& axis)
{
  double inner = std::numeric_limits<double>::infinity(), outer = 0;
  for (Eigen::Index i = 0; i < part.extremes.cols(); ++i) {
    const Point d = part.extremes.col(i) + part.centre - axis.point;
    const double radius = (d - d.dot(axis.direction) * axis.direction).norm();
    inner = std::min(inner, radius);
    outer = std::max(outer, radius);
  }
  return inner <= star_core * outer;
}

/// The ring of parts at one height and radius; none if they are not evenly turned copies.
inline std::optional<Symmetry_candidate> make_ring(const Part_relations& parts, const std::vector<Ring_place>& places,
                                                   const Axis& axis)
{
  const std::size_t n = places.size();
  if (n < 3 || !is_evenly_turned(places)) return std::nullopt;
  const bool star = comes_from_axis(parts[places[0].part], axis);
  const bool vertical = std::abs(axis.direction.y()) > 0.5;
  if (!vertical && n < least_horizontal_ring && !star) return std::nullopt;
  Symmetry_candidate ring;
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(full_turn / double(n), axis.direction).toRotationMatrix();
  for (std::size_t i = 0; i < n; ++i) {
    ring.members.push_back(places[i].part);
    ring.links.push_back({i, (i + 1) % n, turn, true});
    if (!std::isfinite(parts.deviation(places[i].part, places[(i + 1) % n].part, turn))) return std::nullopt;
  }
  ring.preference = star ? Preference::STAR : Preference::RING;
  ring.symmetry.type = Symmetry_type::ROTATION;
  ring.symmetry.point = axis.point;
  ring.symmetry.direction = axis.direction;
  ring.symmetry.order = static_cast<int>(n);
  return ring;
}

/// Adds the rings about one axis. \return whether there are any
inline bool add_rings_about(const Part_relations& parts, const std::vector<std::size_t>& candidates, const Axis& axis,
                            Largest_candidates& result)
{
  bool found = false;
  const std::vector<Ring_place> places = places_about(parts, candidates, axis);
  std::vector<char> used(places.size(), 0);
  for (std::size_t seed = 0; seed < places.size(); ++seed) {
    const double tolerance = parts.position_tolerance(places[seed].part);
    if (used[seed] || places[seed].radius <= 1.5 * tolerance) continue;
    std::vector<Ring_place> same;
    for (std::size_t i = 0; i < places.size(); ++i)
      if (std::abs(places[i].height - places[seed].height) <= tolerance &&
          std::abs(places[i].radius - places[seed].radius) <= tolerance) {
        same.push_back(places[i]);
        used[i] = 1;
      }
    if (auto ring = make_ring(parts, same, axis)) {
      result.add(*ring);
      found = true;
    }
  }
  return found;
}

inline Point mean_centre(const Part_relations& parts, const std::vector<std::size_t>& set)
{
  Point sum = Point::Zero();
  for (std::size_t i : set)
    sum += parts[i].centre;
  return sum / set.size();
}

/// The directions of least and most spread of the centres of a set.
struct Spread
{
  Point least, most;
};

inline Spread spread(const Part_relations& parts, const std::vector<std::size_t>& set, const Point& mean)
{
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (std::size_t i : set) {
    const Point d = parts[i].centre - mean;
    covariance += d * d.transpose();
  }
  const Eigen::Matrix3d axes = eigen_system(covariance).vectors;
  return {axes.col(0), axes.col(2)};
}

inline std::array<std::vector<std::size_t>, 2> split_at_gap(const Part_relations& parts, std::vector<std::size_t> set,
                                                            const Point& direction)
{
  const auto along = [&](std::size_t i) { return parts[i].centre.dot(direction); };
  std::stable_sort(set.begin(), set.end(), [&](std::size_t a, std::size_t b) { return along(a) < along(b); });
  std::size_t cut = 1;
  for (std::size_t i = 1; i < set.size(); ++i)
    if (along(set[i]) - along(set[i - 1]) > along(set[cut]) - along(set[cut - 1]) + 1e-9) cut = i;
  return {{{set.begin(), set.begin() + cut}, {set.begin() + cut, set.end()}}};
}

/// Adds rings of parts of one size: about the vertical axis and a horizontal axis through their mean; if there are
/// none, those in the two subsets on either side of the widest gap.
inline void add_rings_among(const Part_relations& parts, const std::vector<std::size_t>& set, int splits,
                            Largest_candidates& result)
{
  if (set.size() < 3) return;
  const Point mean = mean_centre(parts, set);
  bool found = add_rings_about(parts, set, {mean, Point::UnitY()}, result);
  const Spread directions = spread(parts, set, mean);
  Point normal = directions.least;
  if (std::abs(normal.y()) <= horizontal_limit) {
    normal.y() = 0;
    normal.normalize();
    found = add_rings_about(parts, set, {mean, rightward(normal)}, result) || found;
  }
  if (found || splits == 0) return;
  for (const auto& half : split_at_gap(parts, set, directions.most))
    add_rings_among(parts, half, splits - 1, result);
}

inline void add_rings(const Part_relations& parts, const std::vector<std::size_t>& free, Largest_candidates& result)
{
  constexpr int most_splits = 3;
  std::vector<char> used(parts.size(), 0);
  for (std::size_t seed : free) {
    if (used[seed]) continue;
    std::vector<std::size_t> same;
    for (std::size_t i : free)
      if (parts.same_size(seed, i)) {
        same.push_back(i);
        used[i] = 1;
      }
    add_rings_among(parts, same, most_splits, result);
    const double x = parts.plane(MIRRORED_X).value_or(0), z = parts.plane(MIRRORED_Z).value_or(0);
    add_rings_about(parts, same, {Point(x, 0, z), Point::UnitY()}, result);
  }
}

} // namespace symmetry
} // namespace CGAL::Shape_correspondence::internal

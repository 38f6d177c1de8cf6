// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "base/eigen_system.h"
#include "structure/Symmetry_candidate.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <iterator>
#include <vector>

namespace CGAL::Shape_correspondence::internal::symmetry {

/// For a pair related by a half turn: least sine of the angles of the line between the centres with the mirror plane
/// and with its normal.
constexpr double least_oblique_sine = 0.2;
/// Greatest offset of a mirrored pair's midpoint from the mirror plane, over the distance between its parts along the
/// normal.
constexpr double plane_share = 0.1;

inline Symmetry mirror(const Point& point, const Point& normal)
{
  Symmetry result;
  result.type = Symmetry_type::REFLECTION;
  result.point = point;
  result.direction = normal;
  return result;
}

/// Of two opposite directions, the one that points up, or else to the front, or else to the right.
inline Point upward(const Point& direction)
{
  constexpr double level_limit = 1e-9;
  const bool level = std::abs(direction.y()) <= level_limit;
  const bool keep =
      level ? direction.z() > level_limit || (direction.z() >= -level_limit && direction.x() > 0) : direction.y() > 0;
  return keep ? direction : Point(-direction);
}

/// Distance of a point from a mirror plane of the shape; 1 if the shape has none.
inline double plane_distance(const Part_relations& parts, Basic_map map, const Point& middle)
{
  return parts.plane(map) ? std::abs(middle[axis_of(map)] - *parts.plane(map)) : 1;
}

/// Adds the orbits under two mirror planes of a part i with its image j in the main plane and k in the other one.
inline void add_four(const Part_relations& parts, std::size_t i, std::size_t j, std::size_t k,
                     const std::vector<std::size_t>& free, Largest_candidates& result)
{
  const Basic_map main = parts.main_mirror(), other = parts.other_mirror();
  const Point expected = parts[j].centre + parts[k].centre - parts[i].centre;
  for (std::size_t l : free) {
    if (l == i || l == j || l == k || !parts.related(k, l, main) || !parts.related(j, l, other)) continue;
    if ((parts[l].centre - expected).norm() > 2 * parts.position_tolerance(i)) continue;
    Symmetry_candidate four;
    four.members = {i, j, k, l};
    four.preference = Preference::FOUR_MIRRORED;
    const Point middle = (parts[i].centre + parts[j].centre + parts[k].centre + parts[l].centre) / 4;
    four.symmetry = mirror(middle, Point::Unit(axis_of(main)));
    const double spread = (parts[i].centre - parts[l].centre).norm();
    four.cost =
        rounded(plane_distance(parts, main, middle) + plane_distance(parts, other, middle) + 0.01 / (1 + spread));
    four.links = {{0, 1, matrix_of(main), false}, {2, 3, matrix_of(main), false}, {0, 2, matrix_of(other), true}};
    result.add(four);
  }
}

/// Adds orbits of four parts under reflection in two orthogonal planes, such as the legs of a chair.
inline void add_orbits_of_four(const Part_relations& parts, const std::vector<std::size_t>& free,
                               Largest_candidates& result)
{
  const auto is_pair = [&](std::size_t i, std::size_t j, Basic_map map) {
    return parts[i].centre[axis_of(map)] > parts[j].centre[axis_of(map)] && parts.related(i, j, map) &&
           parts.displaced_along(i, j, map);
  };
  for (std::size_t i : free) {
    std::vector<std::size_t> images; // mirror images in the other plane
    std::copy_if(free.begin(), free.end(), std::back_inserter(images),
                 [&](std::size_t k) { return is_pair(i, k, parts.other_mirror()); });
    for (std::size_t j : free) {
      if (images.empty() || !is_pair(i, j, parts.main_mirror())) continue;
      for (std::size_t k : images)
        add_four(parts, i, j, k, free, result);
    }
  }
}

/// Adds a pair mirrored in one of the shape's mirror planes.
inline void add_pair_in_plane(const Part_relations& parts, std::size_t i, std::size_t j, Basic_map map,
                              Largest_candidates& result)
{
  const int axis = axis_of(map);
  if (!parts.plane(map) || !parts.related(i, j, map) || !parts.displaced_along(i, j, map)) return;
  const Point middle = (parts[i].centre + parts[j].centre) / 2;
  const double apart = std::abs(parts[i].centre[axis] - parts[j].centre[axis]);
  if (std::abs(middle[axis] - *parts.plane(map)) > std::max(plane_tolerance, plane_share * apart)) return;
  Symmetry_candidate pair;
  pair.members = {i, j};
  if (parts[i].centre[axis] < parts[j].centre[axis]) std::swap(pair.members[0], pair.members[1]);
  pair.preference = Preference::MIRRORED_IN_SHAPE;
  pair.symmetry = mirror(middle[axis] * Point::Unit(axis), Point::Unit(axis));
  const Point across = parts[i].centre - parts[j].centre;
  pair.cost = rounded(std::abs(middle[axis] - *parts.plane(map)) + across.norm() - std::abs(across[axis]));
  pair.links = {{0, 1, matrix_of(map), map != parts.main_mirror()}};
  result.add(pair);
}

/// Adds a pair related by half a turn about an axis in a mirror plane of the shape, across the line of their centres.
inline void add_turned_pair(const Part_relations& parts, std::size_t i, std::size_t j, Basic_map map,
                            Largest_candidates& result)
{
  const int normal = axis_of(map);
  const Point middle = (parts[i].centre + parts[j].centre) / 2, between = parts[i].centre - parts[j].centre;
  if (!parts.plane(map) || std::abs(middle[normal] - *parts.plane(map)) > plane_tolerance) return;
  const Point axis = between.cross(Point::Unit(normal));
  const double oblique = std::max(least_position_tolerance, least_oblique_sine * between.norm());
  if (std::min(std::abs(between[normal]), axis.norm()) <= oblique) return;
  Symmetry_candidate pair;
  pair.members = {i, j};
  if (between[normal] < 0) std::swap(pair.members[0], pair.members[1]);
  pair.preference = Preference::TURNED;
  pair.symmetry.type = Symmetry_type::ROTATION;
  pair.symmetry.point = middle;
  pair.symmetry.direction = upward(axis.normalized());
  pair.symmetry.order = 2;
  pair.cost = rounded(between.norm() - pair.symmetry.direction.y());
  const Eigen::Matrix3d half_turn = -mirror_matrix(pair.symmetry.direction);
  if (!std::isfinite(parts.deviation(i, j, half_turn))) return;
  pair.links = {{0, 1, half_turn, true}};
  result.add(pair);
}

inline void add_translated_pair(const Part_relations& parts, std::size_t i, std::size_t j, Largest_candidates& result)
{
  Point vector = parts[j].centre - parts[i].centre;
  if (!parts.related(i, j, TRANSLATED) || vector.norm() <= least_position_tolerance) return;
  Symmetry_candidate pair;
  pair.members = {i, j};
  if (is_backward(vector)) {
    std::swap(pair.members[0], pair.members[1]);
    vector = -vector;
  }
  pair.preference = Preference::TRANSLATED;
  pair.symmetry.type = Symmetry_type::TRANSLATION;
  pair.symmetry.point = parts[pair.members[0]].centre;
  pair.symmetry.direction = vector;
  pair.cost = rounded(vector.norm());
  pair.links = {{0, 1, matrix_of(TRANSLATED), !(parts.is_wheel(i) && parts.is_wheel(j))}};
  result.add(pair);
}

/// Adds a pair mirrored in the vertical plane midway between its centres.
inline void add_pair_mirrored_anyhow(const Part_relations& parts, std::size_t i, std::size_t j,
                                     Largest_candidates& result)
{
  Point across = parts[i].centre - parts[j].centre;
  const double height = std::abs(across.y());
  across.y() = 0;
  if (height > parts.position_tolerance(i) || across.norm() <= std::max(least_position_tolerance, height)) return;
  const Point normal = rightward(across.normalized());
  if (!std::isfinite(parts.deviation(i, j, mirror_matrix(normal)))) return;
  Symmetry_candidate pair;
  pair.members = {i, j};
  if (normal.dot(across) < 0) std::swap(pair.members[0], pair.members[1]);
  pair.preference = Preference::MIRRORED_ANYHOW;
  pair.symmetry = mirror((parts[i].centre + parts[j].centre) / 2, normal);
  pair.cost = rounded(across.norm());
  pair.links = {{0, 1, mirror_matrix(normal), true}};
  result.add(pair);
}

/// The symmetry of a part that is a group alone: reflection in its own mirror plane, if it has one.
inline Symmetry self_symmetry(Part_relations& parts, std::size_t i)
{
  for (const Basic_map map : {parts.main_mirror(), parts.other_mirror()}) {
    if (!parts.related(i, i, map) || !parts.confirm(i, i, matrix_of(map))) continue;
    Symmetry result = mirror(parts[i].centre, map == MIRRORED_X ? Point::UnitX() : Point::UnitZ());
    result.type = Symmetry_type::SELF;
    result.residual = parts.deviation(i, i, matrix_of(map));
    return result;
  }
  Symmetry none;
  none.point = parts[i].centre;
  return none;
}

constexpr auto full_turn = double(2 * EIGEN_PI);
constexpr double uneven_angle = 0.15; ///< largest deviation of an angle between neighbours from the mean, over the mean
constexpr double star_core = 0.4;     ///< largest ratio of inner and outer radius of a star's members
constexpr double horizontal_limit = 0.1; ///< largest vertical component of an axis that counts as horizontal
/// Number of members from which on parts around a horizontal axis count as a ring. Fewer do only if they form a star:
/// the four sides of a picture frame are no ring.
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

/// Adds rings of parts of one size about the vertical axis and a horizontal axis through their mean; if there are none,
/// splits the parts at the widest gap, up to `splits` times, and looks for rings on either side.
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

} // namespace CGAL::Shape_correspondence::internal::symmetry

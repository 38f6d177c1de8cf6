// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "shape/Flat_faces.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

namespace CGAL::Shape_correspondence::internal {

Sorted_triangles::Sorted_triangles(const Part_mesh& mesh)
{
  std::vector<char> is_used(std::size_t(mesh.points.cols()), 0);
  for (int v : mesh.triangles.reshaped())
    is_used[std::size_t(v)] = 1;
  std::vector<std::pair<std::array<double, 3>, int>> places; // 0. + x turns -0 into 0
  for (int v = 0; v < int(is_used.size()); ++v)
    if (is_used[std::size_t(v)])
      places.push_back({{0. + mesh.points(0, v), 0. + mesh.points(1, v), 0. + mesh.points(2, v)}, v});
  std::sort(places.begin(), places.end());
  std::vector<int> number(is_used.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto& [x, y, z] = places[i].first;
    if (i == 0 || places[i].first != places[i - 1].first) points.emplace_back(x, y, z);
    number[std::size_t(places[i].second)] = int(points.size()) - 1;
  }
  for (const auto& t : mesh.triangles.colwise()) {
    Corners corners{number[std::size_t(t[0])], number[std::size_t(t[1])], number[std::size_t(t[2])]};
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue;
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    triangles.push_back(corners);
  }
  std::sort(triangles.begin(), triangles.end());
}

Part_mesh sorted_mesh(const std::vector<Point>& points, const std::vector<Corners>& triangles,
                      const std::vector<double>& place)
{
  std::vector<int> number(place.size(), -1), order;
  for (const Corners& c : triangles)
    for (int v : c)
      if (std::exchange(number[std::size_t(v)], 0) < 0) order.push_back(v);
  std::sort(order.begin(), order.end(),
            [&](int a, int b) { return std::tie(place[std::size_t(a)], a) < std::tie(place[std::size_t(b)], b); });
  Part_mesh result;
  result.points.resize(3, Eigen::Index(order.size()));
  for (std::size_t i = 0; i < order.size(); ++i) {
    number[std::size_t(order[i])] = int(i);
    result.points.col(Eigen::Index(i)) = points[std::size_t(order[i])];
  }
  std::vector<std::tuple<double, Corners, Corners>> keyed; // place of the centre, sorted corners, corners
  for (Corners c : triangles) {
    for (int& v : c)
      v = number[std::size_t(v)];
    std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
    const Corners sorted{c[0], std::min(c[1], c[2]), std::max(c[1], c[2])};
    double sum = 0;
    for (int v : sorted)
      sum += place[std::size_t(order[std::size_t(v)])];
    keyed.emplace_back(sum, sorted, c);
  }
  std::sort(keyed.begin(), keyed.end());
  const auto is_same = [](const auto& a, const auto& b) { return std::get<1>(a) == std::get<1>(b); };
  keyed.erase(std::unique(keyed.begin(), keyed.end(), is_same), keyed.end());
  result.triangles.resize(3, Eigen::Index(keyed.size()));
  Eigen::Index t = 0;
  for (const auto& [sum, sorted, c] : keyed)
    result.triangles.col(t++) << c[0], c[1], c[2];
  return result;
}

Groups::Groups(const std::vector<int>& group_of) : members_(group_of.size())
{
  begin_.assign(group_of.empty() ? 1 : 2 + std::size_t(*std::max_element(group_of.begin(), group_of.end())), 0);
  for (int group : group_of)
    ++begin_[std::size_t(group) + 1];
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  std::vector<std::size_t> next = begin_;
  for (std::size_t i = 0; i < group_of.size(); ++i)
    members_[next[std::size_t(group_of[i])]++] = int(i);
}

/// Sets of triangles (one triangle or an exactly flat face each) that are joined to faces, and sums over each set.
struct Flat_faces::Units
{
  Units(const Flat_faces& mesh, const std::vector<int>& unit)
      : unit_of(unit),
        triangles(unit),
        area_vectors(triangles.size(), Point::Zero()),
        moments(triangles.size(), Point::Zero()),
        areas(triangles.size(), 0)
  {
    for (std::size_t i = 0; i < triangles.size(); ++i)
      for (int t : triangles[i]) {
        const Point& vector = mesh.area_vector(t);
        const double area = vector.norm();
        area_vectors[i] += vector;
        areas[i] += area;
        moments[i] += area / 3 * (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2));
      }
  }

  const std::vector<int>& unit_of; ///< indexed by triangle
  Groups triangles;
  std::vector<Point> area_vectors;
  std::vector<Point> moments; ///< sums of twice the area times the centre
  std::vector<double> areas;  ///< twice the areas
};

Flat_faces::Flat_faces(const Part_mesh& mesh, double tolerance) : tolerance_(tolerance), sorted_(mesh)
{
  for (int t = 0; t < int(triangles().size()); ++t)
    area_vectors_.push_back((corner(t, 1) - corner(t, 0)).cross(corner(t, 2) - corner(t, 0)));
  find_sides();
  std::vector<int> own(triangles().size());
  std::iota(own.begin(), own.end(), 0);
  exact_ = grown(Units(*this, own), Point::Zero(), exact_tolerance());
}

double Flat_faces::exact_tolerance() const { return 2e-4 * tolerance_; }

std::vector<int> Flat_faces::nearly_flat(const Point& direction) const
{
  return grown(Units(*this, exact_), direction, tolerance_);
}

void Flat_faces::find_sides()
{
  sides_.reserve(3 * triangles().size());
  for (std::size_t i = 0; i < 3 * triangles().size(); ++i) {
    const Corners& corners = triangles()[i / 3];
    const auto [low, high] = std::minmax(corners[i % 3], corners[(i + 1) % 3]);
    sides_.push_back({std::uint64_t(low) << 32 | std::uint64_t(high), int(i)});
  }
  std::sort(sides_.begin(), sides_.end(), [](const Side_of_triangle& a, const Side_of_triangle& b) {
    return std::tie(a.edge, a.corner) < std::tie(b.edge, b.corner);
  });
  neighbours_.assign(sides_.size(), -1);
  for_each_edge([&](const Side_range& sides) {
    const auto count = sides.second - sides.first;
    if (count == 2 || count == 4) join_sides(sides);
  });
}

/// Makes neighbours of the triangles at an edge that are oriented alike; of four, of those that face the same way.
void Flat_faces::join_sides(const Side_range& sides)
{
  const auto runs_up = [&](const Side_of_triangle& side) {
    const Corners& corners = triangles()[std::size_t(side.triangle())];
    return corners[std::size_t(side.corner % 3)] < corners[std::size_t((side.corner + 1) % 3)];
  };
  const auto normal = [&](const Side_of_triangle& side) { return area_vector(side.triangle()).normalized(); };
  for (const Side_of_triangle* i = sides.first; i != sides.second; ++i) {
    if (!runs_up(*i)) continue;
    std::pair best(-2., sides.second);
    for (const Side_of_triangle* j = sides.first; j != sides.second; ++j)
      if (!runs_up(*j) && neighbour(j->corner) < 0)
        best = std::max(best, std::pair(sides.second - sides.first == 2 ? 1 : normal(*i).dot(normal(*j)), j));
    if (best.second == sides.second) continue;
    neighbours_[std::size_t(i->corner)] = best.second->triangle();
    neighbours_[std::size_t(best.second->corner)] = i->triangle();
  }
}

/// Joins adjacent units to flat faces, beginning with the largest. \return indexed by triangle: the number of its face
std::vector<int> Flat_faces::grown(const Units& units, const Point& direction, double tolerance) const
{
  const double steps = 3; // steps per unit of the logarithm of an area: rounding does not decide between equal areas
  std::vector<std::tuple<double, double, int>> order; // negated log area in steps, place along the direction, unit
  for (std::size_t i = 0; i < units.areas.size(); ++i) {
    const double area = units.areas[i];
    const Point centre = area > 0 ? Point(units.moments[i] / area) : corner(*units.triangles[i].begin(), 0);
    order.emplace_back(area > 0 ? -std::round(steps * std::log(area)) : std::numeric_limits<double>::max(),
                       direction.dot(centre - points()[0]), int(i));
  }
  std::sort(order.begin(), order.end());
  std::vector<int> rank(order.size()), face(order.size(), -1), members, next;
  for (std::size_t i = 0; i < order.size(); ++i)
    rank[std::size_t(std::get<2>(order[i]))] = int(i);
  int faces = 0;
  for (const auto& [step, place, seed] : order) {
    if (face[std::size_t(seed)] >= 0) continue;
    face[std::size_t(seed)] = faces;
    members.assign(1, seed);
    Point normal = Point::Zero(), moment = Point::Zero();
    double area = 0;
    for (std::size_t m = 0; m < members.size(); ++m) {
      const auto unit = std::size_t(members[m]);
      normal += units.area_vectors[unit];
      moment += units.moments[unit];
      area += units.areas[unit];
      if (!(area > 0)) continue;
      next.clear();
      for (int t : units.triangles[unit])
        for (int k = 0; k < 3; ++k) {
          const int other = neighbour(3 * t + k);
          const int there = other < 0 ? -1 : units.unit_of[std::size_t(other)];
          if (there >= 0 && face[std::size_t(there)] < 0) next.push_back(rank[std::size_t(there)]);
        }
      std::sort(next.begin(), next.end());
      next.erase(std::unique(next.begin(), next.end()), next.end());
      for (int i : next) {
        const int there = std::get<2>(order[std::size_t(i)]);
        if (!is_flat(units, there, normal.normalized(), moment / area, tolerance)) continue;
        face[std::size_t(there)] = faces;
        members.push_back(there);
      }
    }
    ++faces;
  }
  std::vector<int> result;
  for (int unit : units.unit_of)
    result.push_back(face[std::size_t(unit)]);
  return result;
}

/// Whether the triangles of a unit lie in a plane and are not folded over.
bool Flat_faces::is_flat(const Units& units, int unit, const Point& normal, const Point& centre, double tolerance) const
{
  const double least_cosine = 0.5; // least area projected on the plane, over the area, of a unit that is not folded
  const auto i = std::size_t(unit);
  for (int t : units.triangles[i])
    for (int k = 0; k < 3; ++k)
      if (std::abs(normal.dot(corner(t, k) - centre)) > tolerance) return false;
  if (units.area_vectors[i].dot(normal) > least_cosine * units.areas[i]) return true;
  double longest = 0;
  for (int t : units.triangles[i])
    for (int k = 0; k < 3; ++k)
      longest = std::max(longest, (corner(t, (k + 1) % 3) - corner(t, k)).norm());
  return units.areas[i] <= tolerance * longest;
}

} // namespace CGAL::Shape_correspondence::internal

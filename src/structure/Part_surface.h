// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "base/Disjoint_sets.h"
#include "shape/Triangle_tree.h"
#include "shape/sample_triangles.h"

#include <CGAL/Shape_correspondence/Segmented_shape.h>
#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <queue>
#include <string>
#include <tuple>
#include <vector>

namespace CGAL::Shape_correspondence::internal::contacts {

inline Box widened(const Box& box, double by)
{
  return Box(box.min() - Point::Constant(by), box.max() + Point::Constant(by));
}

/// A convex polygon: a clipped triangle.
using Polygon = std::vector<Point>;

/// The polygon clipped to the half-space sign · coordinate ≤ sign · bound.
inline Polygon clipped(const Polygon& polygon, int axis, double bound, double sign)
{
  Polygon result;
  result.reserve(polygon.size() + 1);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double a = sign * (bound - p[axis]), b = sign * (bound - q[axis]);
    if (a >= 0) result.push_back(p);
    if ((a > 0 && b < 0) || (a < 0 && b > 0)) result.push_back(p + (a / (a - b)) * (q - p));
  }
  return result;
}

inline Polygon clipped(Polygon polygon, const Box& box)
{
  for (int axis = 0; axis < 3 && !polygon.empty(); ++axis) {
    polygon = clipped(polygon, axis, box.max()[axis], 1);
    polygon = clipped(polygon, axis, box.min()[axis], -1);
  }
  return polygon;
}

inline void add_fan(const Polygon& polygon, std::vector<Sampled_triangle>& triangles)
{
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const Point u = polygon[i - 1] - polygon[0], v = polygon[i] - polygon[0];
    const double area = u.cross(v).norm() / 2;
    if (area > 0) triangles.push_back({polygon[0], u, v, area});
  }
}

/// The surface of a part with a tree for distance queries.
class Part_surface
{
public:
  /// \param points vertices of the mesh, in the coordinates of the queries
  Part_surface(const Points& points, const Eigen::Matrix3Xi& triangles) : tree_(proper_triangles(points, triangles)) {}

  const Box& box() const { return tree_.box(); }
  const Triangle_tree& tree() const { return tree_; }

  /// Whether the other surface is inside, by the majority of three rays, since the mesh may have small holes.
  bool encloses(const Part_surface& other) const
  {
    if (other.tree_.triangles().empty() || !box().contains(other.box())) return false;
    const Point& p = other.tree_.triangles().front()[0];
    const std::array<Point, 3> directions = {Point(1, 0.1234, 0.0567), Point(-0.0891, 1, 0.1417),
                                             Point(0.1031, -0.0713, 1)};
    int odd = 0;
    for (const Point& direction : directions)
      odd += tree_.crossings(p, direction) % 2;
    return odd >= 2;
  }

  /// About `n` samples of the marked triangles clipped to `region`; then their corners, with area 0, if at most `n`.
  Surface_samples sample(const std::vector<char>& marked, const Box& region, int n) const
  {
    std::vector<Sampled_triangle> pieces;
    std::vector<Point> vertices;
    std::vector<std::size_t> order; // the triangles in the order of the mesh
    for (std::size_t t = 0; t < marked.size(); ++t)
      if (marked[t]) order.push_back(t);
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return tree_.given_number(a) < tree_.given_number(b); });
    for (std::size_t t : order) {
      const Triangle& triangle = tree_.triangles()[t];
      Polygon polygon(triangle.begin(), triangle.end());
      if (!region.contains(box_of(triangle))) polygon = clipped(std::move(polygon), region);
      add_fan(polygon, pieces);
      vertices.insert(vertices.end(), polygon.begin(), polygon.end());
    }
    Surface_samples samples = sample_triangles(pieces, n);
    if (vertices.size() <= static_cast<std::size_t>(n)) {
      samples.points.insert(samples.points.end(), vertices.begin(), vertices.end());
      samples.areas.resize(samples.points.size(), 0.0);
    }
    return samples;
  }

  Box box_of_marked(const std::vector<char>& marked) const
  {
    Box result;
    for (std::size_t t = 0; t < marked.size(); ++t)
      if (marked[t]) result.extend(box_of(tree_.triangles()[t]));
    return result;
  }

private:
  static std::vector<Triangle> proper_triangles(const Points& points, const Eigen::Matrix3Xi& triangles)
  {
    constexpr double least_relative_area = 1e-12; // twice the area of a triangle used, over its squared longest side
    std::vector<Triangle> result;
    for (Eigen::Index t = 0; t < triangles.cols(); ++t) {
      const Triangle corners = {points.col(triangles(0, t)), points.col(triangles(1, t)), points.col(triangles(2, t))};
      const Point u = corners[1] - corners[0], v = corners[2] - corners[0];
      const double longest = std::max({u.squaredNorm(), v.squaredNorm(), (v - u).squaredNorm()});
      if (u.cross(v).norm() > least_relative_area * longest) result.push_back(corners);
    }
    return result;
  }

  Triangle_tree tree_;
};

/// Two parts and their distance, which is 0 where they overlap.
struct Near_pair
{
  std::array<std::size_t, 2> parts;
  double distance;
  std::size_t region; ///< index of the place where they are closest, in a list that the maker of the pair keeps
};

inline std::string join_warning(const std::vector<Part_abstraction>& parts, const Near_pair& pair, double diagonal)
{
  const double percent = std::round(1000 * pair.distance / diagonal) / 10;
  std::string digits = std::to_string(percent);
  digits.resize(digits.find_first_of(".,") + 2);
  return "Parts '" + parts[pair.parts[0]].name + "' and '" + parts[pair.parts[1]].name +
         "' are taken to be in contact across a gap of " + digits +
         " % of the shape's diagonal, since the shape would fall into pieces otherwise.";
}

/// Connects the connected components that the near pairs leave, by the closest pairs (Kruskal's minimum spanning
/// forest). A distance is computed only once its lower bound is the least.
/// \tparam LowerBound maps two parts to a lower bound of their distance
/// \tparam Measure maps two parts to a `Near_pair`
template <typename LowerBound, typename Measure>
void join_pieces(const std::vector<Part_abstraction>& parts, double diagonal, const LowerBound& lower_bound,
                 const Measure& measure, std::vector<Near_pair>& near, std::vector<std::string>& warnings)
{
  Disjoint_sets pieces(parts.size());
  for (const Near_pair& pair : near)
    pieces.unite(pair.parts[0], pair.parts[1]);
  if (pieces.number_of_sets() == 1) return;

  // (distance or its lower bound, first part, second part, whether the distance is exact); the smallest first
  using Entry = std::tuple<double, std::size_t, std::size_t, bool>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  for (std::size_t a = 0; a < parts.size(); ++a)
    for (std::size_t b = a + 1; b < parts.size(); ++b)
      if (pieces[a] != pieces[b]) queue.emplace(lower_bound(a, b), a, b, false);
  while (pieces.number_of_sets() > 1 && !queue.empty()) {
    const auto [distance, a, b, measured] = queue.top();
    queue.pop();
    if (pieces[a] == pieces[b]) continue;
    const Near_pair pair = measure(a, b);
    if (!measured && pair.distance > distance) {
      queue.emplace(pair.distance, a, b, true);
      continue;
    }
    pieces.unite(a, b);
    near.push_back(pair);
    warnings.push_back(join_warning(parts, pair, diagonal));
  }
}

inline void sort_by_parts(std::vector<Near_pair>& near)
{
  std::sort(near.begin(), near.end(), [](const Near_pair& a, const Near_pair& b) { return a.parts < b.parts; });
}

} // namespace CGAL::Shape_correspondence::internal::contacts

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Distance_grid.h"

#include "shape/Triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace CGAL::Shape_correspondence::internal {
namespace {

constexpr int most_cells = 36, least_cells = 10; // along an axis of the box
constexpr int margin = 3;                        // points around the box

} // namespace

Distance_grid::Distance_grid(const Point& half_extents) : half_extents_(half_extents)
{
  const double longest = half_extents.maxCoeff();
  for (int axis = 0; axis < 3; ++axis) {
    const int cells = std::clamp(int(std::ceil(most_cells * half_extents[axis] / longest)), least_cells, most_cells);
    spacing_[axis] = 2 * half_extents[axis] / cells;
    counts_[std::size_t(axis)] = cells + 1 + 2 * margin;
  }
  low_ = -half_extents - margin * spacing_;
}

Distance_grid::Cell Distance_grid::cell(std::size_t point) const
{
  const auto i = int(point % std::size_t(counts_[0]));
  const std::size_t rest = point / std::size_t(counts_[0]);
  return {i, int(rest % std::size_t(counts_[1])), int(rest / std::size_t(counts_[1]))};
}

bool Distance_grid::contains(const Cell& point) const
{
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (point[axis] < 0 || point[axis] >= counts_[axis]) return false;
  return true;
}

template <typename Visit>
void Distance_grid::visit_neighbours(std::size_t point, bool diagonal, const Visit& visit) const
{
  const Cell c = cell(point);
  for (int z = -1; z <= 1; ++z)
    for (int y = -1; y <= 1; ++y)
      for (int x = -1; x <= 1; ++x) {
        const int steps = std::abs(x) + std::abs(y) + std::abs(z);
        const Cell other = {c[0] + x, c[1] + y, c[2] + z};
        if (steps == 0 || (steps > 1 && !diagonal) || !contains(other)) continue;
        visit(index(other[0], other[1], other[2]));
      }
}

/// Reaches all points that are connected with the seed and for which `is_in(point)` holds. \return their number
template <typename Is_in>
std::size_t Distance_grid::flood(std::size_t seed, bool diagonal, std::vector<char>& is_reached,
                                 const Is_in& is_in) const
{
  std::vector<std::size_t> open = {seed};
  is_reached[seed] = 1;
  std::size_t result = 0;
  while (!open.empty()) {
    const std::size_t point = open.back();
    open.pop_back();
    ++result;
    visit_neighbours(point, diagonal, [&](std::size_t next) {
      if (is_reached[next] || !is_in(next)) return;
      is_reached[next] = 1;
      open.push_back(next);
    });
  }
  return result;
}

/// The points of the surface nearest to all points of the grid: what is nearest to one is likely to be near the next.
std::vector<Point> Distance_grid::nearest_points(const Part_mesh& surface) const
{
  const contacts::Triangle_tree tree = tree_of(surface.points, surface.triangles);
  std::vector<Point> result;
  std::size_t triangle = 0;
  for (std::size_t p = 0; p < number_of_points(); ++p)
    result.push_back(tree.nearest(at(p), triangle));
  return result;
}

/// The point of the grid nearest to `p`.
std::size_t Distance_grid::nearest_grid_point(const Point& p) const
{
  const Point steps = (p - low_).cwiseQuotient(spacing_);
  Cell c{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    c[axis] = std::clamp(int(std::lround(steps[Eigen::Index(axis)])), 0, counts_[axis] - 1);
  return index(c[0], c[1], c[2]);
}

Distance_grid::Values Distance_grid::signed_distances(const Part_mesh& surface) const
{
  const std::vector<Point> nearest = nearest_points(surface);
  Values distances(nearest.size());
  for (std::size_t p = 0; p < distances.size(); ++p)
    distances[p] = (nearest[p] - at(p)).norm();
  std::vector<char> is_outside(distances.size(), 0);
  flood(0, false, is_outside, [&](std::size_t p) { return distances[p] >= thickness(); });
  Values result(distances.size());
  for (std::size_t p = 0; p < result.size(); ++p) {
    bool is_out = is_outside[p];
    if (distances[p] > 0 && distances[p] < thickness()) { // within the surface: on the side to which it is nearest
      const Point away = (at(p) - nearest[p]) / distances[p];
      is_out = is_outside[nearest_grid_point(at(p) + 2 * thickness() * away)];
    }
    result[p] = (is_out ? distances[p] : -distances[p]) - thickness();
  }
  return result;
}

Part_mesh Distance_grid::level_set(const Values& values, double level) const
{
  const auto is_in = [&](int i, int j, int k) { return values[index(i, j, k)] < level; };
  // A vertex in each cell that the surface passes through, in the middle of its crossings of edges
  std::vector<int> vertices(number_of_points(), -1);
  std::vector<Point> points;
  for (int k = 0; k + 1 < counts_[2]; ++k)
    for (int j = 0; j + 1 < counts_[1]; ++j)
      for (int i = 0; i + 1 < counts_[0]; ++i) {
        Point sum = Point::Zero();
        int crossings = 0;
        for (int corner = 0; corner < 8; ++corner)
          for (int axis = 0; axis < 3; ++axis) {
            if (corner >> axis & 1) continue;
            const int other = corner | 1 << axis;
            const auto place = [&](int c) { return Cell{i + (c & 1), j + (c >> 1 & 1), k + (c >> 2 & 1)}; };
            const Cell a = place(corner), b = place(other);
            const double from = values[index(a[0], a[1], a[2])], to = values[index(b[0], b[1], b[2])];
            if ((from < level) == (to < level)) continue;
            sum += at(a[0], a[1], a[2]) + Point::Unit(axis) * spacing_[axis] * (level - from) / (to - from);
            ++crossings;
          }
        if (crossings == 0) continue;
        vertices[index(i, j, k)] = int(points.size());
        points.push_back(sum / crossings);
      }
  // Four cells around each edge that the surface crosses
  std::vector<Eigen::Vector3i> triangles;
  for (std::size_t p = 0; p < values.size(); ++p) {
    const Cell c = cell(p);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
      Cell next = c;
      ++next[axis];
      if (!contains(next) || c[u] == 0 || c[v] == 0) continue;
      const bool from = is_in(c[0], c[1], c[2]);
      if (from == is_in(next[0], next[1], next[2])) continue;
      const auto vertex = [&](int du, int dv) {
        Cell around = c;
        around[u] += du;
        around[v] += dv;
        return vertices[index(around[0], around[1], around[2])];
      };
      std::array<int, 4> corners = {vertex(-1, -1), vertex(0, -1), vertex(0, 0), vertex(-1, 0)};
      if (*std::min_element(corners.begin(), corners.end()) < 0) continue; // at the border of the grid
      if (!from) std::swap(corners[1], corners[3]);
      triangles.emplace_back(corners[0], corners[1], corners[2]);
      triangles.emplace_back(corners[0], corners[2], corners[3]);
    }
  }
  Part_mesh result{Points(3, Eigen::Index(points.size())), Eigen::Matrix3Xi(3, Eigen::Index(triangles.size()))};
  for (std::size_t i = 0; i < points.size(); ++i)
    result.points.col(Eigen::Index(i)) = points[i];
  for (std::size_t i = 0; i < triangles.size(); ++i)
    result.triangles.col(Eigen::Index(i)) = triangles[i];
  return result;
}

std::size_t Distance_grid::number_below(const Values& values, double level) const
{
  return std::size_t(std::count_if(values.begin(), values.end(), [&](double value) { return value < level; }));
}

Point Distance_grid::extents_below(const Values& values, double level) const
{
  contacts::Box box;
  for (std::size_t p = 0; p < values.size(); ++p) {
    const Cell c = cell(p);
    if (values[p] < level) box.extend(at(c[0], c[1], c[2]));
  }
  if (box.isEmpty()) return Point::Zero();
  return ((box.sizes() + spacing_) / 2).cwiseQuotient(half_extents_);
}

/// By the cubes, squares and edges of the grid whose corners are all below.
int Distance_grid::holes_below(const Values& values, double level) const
{
  int result = 0;
  for (std::size_t p = 0; p < values.size(); ++p) {
    const Cell c = cell(p);
    for (int axes = 0; axes < 8; ++axes) { // of the edge, square or cube that begins at the point
      bool is_in = true;
      for (int corner = 0; corner < 8 && is_in; ++corner) {
        if (corner & ~axes) continue;
        const Cell other = {c[0] + (corner & 1), c[1] + (corner >> 1 & 1), c[2] + (corner >> 2 & 1)};
        is_in = contains(other) && values[index(other[0], other[1], other[2])] < level;
      }
      const int dimension = (axes & 1) + (axes >> 1 & 1) + (axes >> 2 & 1);
      if (is_in) result -= dimension % 2 == 0 ? 1 : -1;
    }
  }
  return result;
}

int Distance_grid::pieces_below(const Values& values, double level) const
{
  constexpr double few = 0.02; // of all
  const auto is_in = [&](std::size_t p) { return values[p] < level; };
  std::vector<char> is_reached(values.size(), 0);
  std::vector<std::size_t> sizes;
  for (std::size_t p = 0; p < values.size(); ++p)
    if (is_in(p) && !is_reached[p]) sizes.push_back(flood(p, true, is_reached, is_in));
  const double least = few * double(std::accumulate(sizes.begin(), sizes.end(), std::size_t(0)));
  return int(std::count_if(sizes.begin(), sizes.end(), [&](std::size_t size) { return double(size) > least; }));
}

} // namespace CGAL::Shape_correspondence::internal

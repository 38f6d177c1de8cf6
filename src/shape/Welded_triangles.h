// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "base/Disjoint_sets.h"

#include <CGAL/Shape_correspondence/Points.h>
#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

using Numbers = std::vector<std::size_t>;

using Grid_cell = std::array<std::int64_t, 3>;

struct Grid_cell_hash
{
  std::size_t operator()(const Grid_cell& c) const
  {
    std::uint64_t h = 1469598103934665603u;
    for (std::int64_t x : c)
      h = (h ^ std::uint64_t(x)) * 1099511628211u;
    return std::size_t(h ^ h >> 29);
  }
};

/// Points sorted into the cubes of a grid with sides of length `cell`, to find points that are near each other.
class Point_grid
{
public:
  Point_grid(const Points& points, double cell) : points_(points), cell_(cell)
  {
    for (Eigen::Index i = 0; i < points.cols(); ++i)
      cells_[cell_of(i)].push_back(std::size_t(i));
  }

  /// Calls a function with the indices and squared distances of the points within `distance` of a point, in its cell
  /// and the 26 cells around it. \param most largest number of points of a cell that are looked at
  template <typename Function>
  void for_each_near(std::size_t i, double distance, std::size_t most, Function function) const
  {
    const auto point = points_.col(Eigen::Index(i));
    const Grid_cell at = cell_of(Eigen::Index(i));
    for (std::int64_t x = -1; x <= 1; ++x)
      for (std::int64_t y = -1; y <= 1; ++y)
        for (std::int64_t z = -1; z <= 1; ++z) {
          const auto cell = cells_.find({at[0] + x, at[1] + y, at[2] + z});
          if (cell == cells_.end()) continue;
          const std::size_t count = std::min(most, cell->second.size());
          for (std::size_t k = 0; k < count; ++k) {
            const std::size_t j = cell->second[k];
            const double squared = (point - points_.col(Eigen::Index(j))).squaredNorm();
            if (j != i && squared <= distance * distance) function(j, squared);
          }
        }
  }

  /// Calls a function with the points of each cell.
  template <typename Function>
  void for_each_cell(Function function) const
  {
    for (const auto& [cell, points] : cells_)
      function(points);
  }

private:
  Grid_cell cell_of(Eigen::Index i) const
  {
    Grid_cell result;
    for (int k = 0; k < 3; ++k)
      result[std::size_t(k)] = std::int64_t(std::floor(points_(k, i) / cell_));
    return result;
  }

  const Points& points_;
  double cell_;
  std::unordered_map<Grid_cell, Numbers, Grid_cell_hash> cells_;
};

constexpr double welding_distance = 1e-5; ///< greatest distance of vertices that are merged, over the diagonal

/// A side of a triangle.
struct Triangle_side
{
  std::size_t low, high; // numbers of the places of its ends; merged vertices have one place
  std::size_t triangle;
  int corner;      // the corner at which it begins
  bool is_forward; // whether it goes from `low` to `high`
};

/// The triangles of all objects, in a frame with y up in which their box begins at the origin and has diagonal 1.
class Welded_triangles
{
public:
  /// \param axes the rows are the axes of the frame
  Welded_triangles(const Segmented_shape& shape, const Eigen::Matrix3d& axes);

  Point sides = Point::Ones();                     ///< lengths of the sides of the box
  double area = 0;                                 ///< area of all triangles
  Points points;                                   ///< the vertices
  Numbers places;                                  ///< indexed by vertex: number of its place, one for merged vertices
  std::vector<std::array<std::size_t, 3>> corners; ///< indexed by triangle: indices of vertices
  Numbers objects;                                 ///< indexed by triangle: the index of its object
  std::vector<double> areas;                       ///< indexed by triangle
  std::vector<Point> normals;                      ///< indexed by triangle
  std::vector<Triangle_side> edges;                ///< the sides of all triangles, sorted by `low` and `high`

  std::size_t size() const { return corners.size(); }
  Point corner(std::size_t t, int k) const { return points.col(Eigen::Index(corners[t][std::size_t(k)])); }
  Point middle(std::size_t t) const { return (corner(t, 0) + corner(t, 1) + corner(t, 2)) / 3; }
  std::size_t place(std::size_t t, int k) const { return places[corners[t][std::size_t(k)]]; }
  bool is_degenerate(std::size_t t) const;
  /// Indexed by place: the triangles with a corner there.
  std::vector<Numbers> triangles_of_places() const;

  double length(const Triangle_side& edge) const;
  /// Cosine of the angle between two triangles' normals; one is reversed if the triangles are oriented differently.
  double cosine(const Triangle_side& a, const Triangle_side& b) const;

  /// Calls a function with the range of each edge's sides in `edges`.
  template <typename Function>
  void for_each_edge(Function function) const
  {
    for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
      while (end < edges.size() && edges[end].low == edges[begin].low && edges[end].high == edges[begin].high)
        ++end;
      function(begin, end);
    }
  }

  /// Calls a function with the common sides of adjacent triangles of the same piece. \param pieces indexed by triangle
  template <typename Function>
  void for_each_neighbours(const Numbers& pieces, Function function) const
  {
    for (std::size_t e = 1; e < edges.size(); ++e) {
      const Triangle_side &a = edges[e - 1], &b = edges[e];
      if (a.low == b.low && a.high == b.high && pieces[a.triangle] == pieces[b.triangle]) function(a, b);
    }
  }

private:
  void collect(const Segmented_shape& shape, const Eigen::Matrix3d& axes);
  void weld();
  void find_edges();
};

/// For each element the number of its set; sets are numbered from 0 on in the order of their first elements.
Numbers numbers_of_sets(const Disjoint_sets& sets);
std::size_t numbers_in(const Numbers& numbers);

} // namespace CGAL::Shape_correspondence::internal

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "base/Disjoint_sets.h"
#include "shape/Point_grid.h"

#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

constexpr double welding_distance = 1e-5; ///< greatest distance of vertices that are merged, over the diagonal

/// A side of a triangle.
struct Triangle_side
{
  std::size_t low, high; // numbers of the places of its ends
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
  Numbers places;                                  ///< indexed by vertex: the number of its place
  std::vector<std::array<std::size_t, 3>> corners; ///< indexed by triangle: indices of vertices
  Numbers objects;                                 ///< indexed by triangle
  std::vector<double> areas;                       ///< indexed by triangle
  std::vector<Point> normals;                      ///< indexed by triangle
  std::vector<Triangle_side> edges;                ///< sorted by `low` and `high`

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

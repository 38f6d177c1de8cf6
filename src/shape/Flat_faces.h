// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "shape/divide_polygon.h"

#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// The triangles of a mesh in sorted order. Vertices at the same place are merged and sorted by their coordinates.
/// Triangles with two corners at the same place are left out; all others begin with their corner of lowest index.
struct Sorted_triangles
{
  explicit Sorted_triangles(const Part_mesh& mesh);

  std::vector<Point> points;
  std::vector<Corners> triangles;
};

/// The mesh of some triangles, without duplicates; vertices and triangles are sorted by position along a direction.
/// \param place indexed by point: its position along the direction
Part_mesh sorted_mesh(const std::vector<Point>& points, const std::vector<Corners>& triangles,
                      const std::vector<double>& place);

/// The members of each group, in ascending order.
class Groups
{
public:
  struct Range
  {
    const int *first, *last;
    const int* begin() const { return first; }
    const int* end() const { return last; }
    std::size_t size() const { return std::size_t(last - first); }
  };

  explicit Groups(const std::vector<int>& group_of);

  std::size_t size() const { return begin_.size() - 1; }
  Range operator[](std::size_t group) const
  {
    return {members_.data() + begin_[group], members_.data() + begin_[group + 1]};
  }

private:
  std::vector<std::size_t> begin_;
  std::vector<int> members_;
};

/// An edge of a triangle.
struct Side_of_triangle
{
  std::uint64_t edge; ///< key of the edge: equal for all sides between the same two vertices
  int corner;         ///< the corner at which it begins: three times the triangle plus the number of the corner

  int triangle() const { return corner / 3; }
};

using Side_range = std::pair<const Side_of_triangle*, const Side_of_triangle*>;

/// The triangles of a mesh, with vertices at the same place merged, and the flat faces that they make.
class Flat_faces
{
public:
  /// \param tolerance greatest distance from the plane of a face that counts as rounding noise
  Flat_faces(const Part_mesh& mesh, double tolerance);

  const std::vector<Point>& points() const { return sorted_.points; }
  const std::vector<Corners>& triangles() const { return sorted_.triangles; }
  /// Normal of a triangle, of length twice its area.
  const Point& area_vector(int triangle) const { return area_vectors_[std::size_t(triangle)]; }

  /// The triangle that continues the surface across the side that begins at a corner, see `join_sides()`; -1: none.
  int neighbour(int corner) const { return neighbours_[std::size_t(corner)]; }

  double tolerance() const { return tolerance_; }
  double exact_tolerance() const; ///< the tolerance of faces that are exactly flat

  /// For each triangle, the number of its exactly flat face.
  const std::vector<int>& exactly_flat() const { return exact_; }

  /// For each triangle, the number of its nearly flat face: exactly flat faces are merged, beginning with the largest.
  /// \param direction orders exactly flat faces of equal area by their position along it
  std::vector<int> nearly_flat(const Point& direction) const;

  template <typename Function>
  void for_each_edge(const Function& function) const
  {
    const Side_of_triangle* const last = sides_.data() + sides_.size();
    for (const Side_of_triangle *begin = sides_.data(), *end = begin; begin != last; begin = end) {
      while (end != last && end->edge == begin->edge)
        ++end;
      function(Side_range(begin, end));
    }
  }

private:
  struct Units;

  const Point& corner(int triangle, int k) const
  {
    return points()[std::size_t(triangles()[std::size_t(triangle)][std::size_t(k)])];
  }
  void find_sides();
  void join_sides(const Side_range& sides);
  std::vector<int> grown(const Units& units, const Point& direction, double tolerance) const;
  bool is_flat(const Units& units, int unit, const Point& normal, const Point& centre, double tolerance) const;

  double tolerance_;
  Sorted_triangles sorted_;
  std::vector<Point> area_vectors_;     ///< indexed by triangle, see `area_vector()`
  std::vector<Side_of_triangle> sides_; ///< sorted by edge
  std::vector<int> neighbours_;         ///< indexed by corner, see `neighbour()`
  std::vector<int> exact_;
};

} // namespace CGAL::Shape_correspondence::internal

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Points.h>
#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// A regular grid of points in and around a box with the middle at the origin, and functions that are given by their
/// values there.
class Distance_grid
{
public:
  using Values = std::vector<double>; ///< by point
  using Cell = std::array<int, 3>;

  /// \param half_extents of the box
  explicit Distance_grid(const Point& half_extents);

  std::size_t number_of_points() const { return std::size_t(counts_[0]) * counts_[1] * counts_[2]; }

  /// Distances from a surface, negative inside. The surface need not be closed nor oriented: inside is what a walk
  /// from the border of the grid does not reach. So that it does not get through, the surface is as thick as a cell.
  Values signed_distances(const Part_mesh& surface) const;
  /// Half of the thickness that a surface gets.
  double thickness() const { return spacing_.norm() / 2; }

  /// The surface where the values are `level`; it looks to where they are greater, and is closed if they are that at
  /// the border (Gibson 1998, "Constrained elastic surface nets", without the relaxation).
  Part_mesh level_set(const Values& values, double level) const;

  std::size_t number_below(const Values& values, double level) const;
  /// How far the points with values below a level extend along the axes, and half a cell beyond, as shares of the box.
  Point extents_below(const Values& values, double level) const;
  /// The number of their pieces, without those that are of few points.
  int pieces_below(const Values& values, double level) const;

  /// The number of holes through them, less that of their pieces.
  int holes_below(const Values& values, double level) const;

private:
  std::size_t index(int i, int j, int k) const { return (std::size_t(k) * counts_[1] + j) * counts_[0] + i; }
  Cell cell(std::size_t point) const;
  bool contains(const Cell& point) const;
  Point at(std::size_t point) const
  {
    const Cell c = cell(point);
    return at(c[0], c[1], c[2]);
  }
  Point at(int i, int j, int k) const { return low_ + spacing_.cwiseProduct(Point(i, j, k)); }
  template <typename Visit>
  void visit_neighbours(std::size_t point, bool diagonal, const Visit& visit) const;
  template <typename Is_in>
  std::size_t flood(std::size_t seed, bool diagonal, std::vector<char>& is_reached, const Is_in& is_in) const;
  std::vector<Point> nearest_points(const Part_mesh& surface) const;
  std::size_t nearest_grid_point(const Point& p) const;

  Point half_extents_, spacing_, low_;
  std::array<int, 3> counts_; ///< of points along the axes
};

} // namespace CGAL::Shape_correspondence::internal

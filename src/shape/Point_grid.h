// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Points.h>

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
  /// and the 26 cells around it. \param most number of points of each cell that are looked at
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

} // namespace CGAL::Shape_correspondence::internal

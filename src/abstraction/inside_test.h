// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// Tests whether a closed mesh encloses points, by the parity of crossings of a ray along z. Triangles are found by a
/// grid over their projections. A point within rounding error of an edge's projection may be judged wrongly.
class Inside_test
{
public:
  explicit Inside_test(const Part_mesh& mesh) : mesh_(mesh)
  {
    const Point low = mesh.points.rowwise().minCoeff(), high = mesh.points.rowwise().maxCoeff();
    low_ = low.head<2>();
    const double triangles_a_cell = 2;
    const double cells = std::max(1., double(mesh.triangles.cols()) / triangles_a_cell);
    const Eigen::Vector2d extent = (high - low).head<2>().cwiseMax(1e-300);
    const double most_cells_a_side = 512;
    const double side = std::sqrt(std::max(extent.prod() / cells, 1e-300));
    for (int d = 0; d < 2; ++d) {
      counts_[d] = int(std::clamp(extent[d] / side, 1., most_cells_a_side));
      cell_[d] = extent[d] / counts_[d];
    }
    std::vector<std::size_t> ends(bin(counts_[0], 0), 0);
    for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t)
      for_each_bin(t, [&](std::size_t b) { ++ends[b]; });
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    starts_ = ends;
    starts_.insert(starts_.begin(), 0);
    in_bins_.resize(starts_.back());
    for (Eigen::Index t = mesh.triangles.cols(); t-- > 0;)
      for_each_bin(t, [&](std::size_t b) { in_bins_[--ends[b]] = t; });
  }

  bool operator()(const Point& p) const
  {
    bool inside = false;
    if (!p.allFinite() || cell_of(p.x(), 0) != clamped_cell_of(p.x(), 0) ||
        cell_of(p.y(), 1) != clamped_cell_of(p.y(), 1)) {
      return false;
    }
    const std::size_t b = bin(clamped_cell_of(p.x(), 0), clamped_cell_of(p.y(), 1));
    for (std::size_t i = starts_[b]; i < starts_[b + 1]; ++i)
      inside ^= is_below(p, in_bins_[i]);
    return inside;
  }

private:
  int cell_of(double x, int d) const { return int(std::floor(std::clamp((x - low_[d]) / cell_[d], -2., 1e6))); }
  int clamped_cell_of(double x, int d) const { return std::clamp(cell_of(x, d), 0, counts_[d] - 1); }
  std::size_t bin(int i, int j) const { return std::size_t(i) * std::size_t(counts_[1]) + std::size_t(j); }

  Point corner(Eigen::Index t, int k) const { return mesh_.points.col(mesh_.triangles(k, t)); }

  /// Calls `f` with every cell that the projection of a triangle may meet.
  template <typename Function>
  void for_each_bin(Eigen::Index t, const Function& f) const
  {
    const Point low = corner(t, 0).cwiseMin(corner(t, 1)).cwiseMin(corner(t, 2));
    const Point high = corner(t, 0).cwiseMax(corner(t, 1)).cwiseMax(corner(t, 2));
    for (int i = clamped_cell_of(low.x(), 0); i <= clamped_cell_of(high.x(), 0); ++i) {
      for (int j = clamped_cell_of(low.y(), 1); j <= clamped_cell_of(high.y(), 1); ++j)
        f(bin(i, j));
    }
  }

  /// Whether, seen along z, a ray from p to greater x crosses the edge ab, lower end included; equal to the bit for ba.
  static bool passes(const Point& a, const Point& b, const Point& p)
  {
    if ((a.y() > p.y()) == (b.y() > p.y())) return false;
    const Point& low = a.y() < b.y() ? a : b;
    const Point& high = a.y() < b.y() ? b : a;
    return p.x() < low.x() + (high.x() - low.x()) * ((p.y() - low.y()) / (high.y() - low.y()));
  }

  /// Whether a ray from p along z meets a triangle.
  bool is_below(const Point& p, Eigen::Index t) const
  {
    const Point a = corner(t, 0), b = corner(t, 1), c = corner(t, 2);
    if (passes(a, b, p) == (passes(b, c, p) != passes(c, a, p))) return false;
    const Point normal = (b - a).cross(c - a);
    return normal.z() != 0 &&
           p.z() < a.z() - (normal.x() * (p.x() - a.x()) + normal.y() * (p.y() - a.y())) / normal.z();
  }

  const Part_mesh& mesh_;
  Eigen::Vector2d low_, cell_;
  int counts_[2];
  std::vector<std::size_t> starts_;   ///< index of the first entry of every cell in `in_bins_`, then that of the end
  std::vector<Eigen::Index> in_bins_; ///< triangles, cell by cell
};

} // namespace CGAL::Shape_correspondence::internal

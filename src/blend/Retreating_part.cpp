// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Retreating_part.h"

#include "shape/oriented_box.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::internal {
namespace {

using Roots = std::vector<Point>;

Point mean(const Roots& roots)
{
  return std::accumulate(roots.begin(), roots.end(), Point(Point::Zero())) / double(roots.size());
}

/// The box around a part along its axes, the longest one first.
struct Part_box : Oriented_box
{
  /// On which side of the middle along an axis all roots are; 0 if on none, or on both.
  int side(const Roots& roots, int axis) const
  {
    constexpr double aside = 0.3; // of the half extent
    int result = 0;
    for (const Point& root : roots) {
      const double at = axes.col(axis).dot(root - centre);
      const int side = std::abs(at) < aside * extents[axis] / 2 ? 0 : at < 0 ? -1 : 1;
      if (side == 0 || side == -result) return 0;
      result = side;
    }
    return result;
  }

  /// The longest axis on one side of which all roots are; a rod does not draw back sideways.
  std::optional<int> retreat(const Roots& roots) const
  {
    for (int axis = 0; axis < 3; ++axis)
      if ((axis == 0 || !is_rod()) && side(roots, axis) != 0) return axis;
    return {};
  }

  bool is_rod() const { return extents[1] <= rod * extents[0]; }

  /// Whether there are roots at an end of the longest axis, -1 or 1.
  bool has_roots_at(const Roots& roots, int end) const
  {
    return std::any_of(roots.begin(), roots.end(), [&](const Point& root) { return side({root}, 0) == end; });
  }

  static constexpr double rod = 0.3; ///< the most of its middle extent over the longest
};

/// Those that are lowest along an axis.
Roots lowest(const Roots& roots, int axis)
{
  constexpr double same = 0.05; // of the height
  double low = roots[0][axis];
  for (const Point& root : roots)
    low = std::min(low, root[axis]);
  Roots result;
  for (const Point& root : roots)
    if (root[axis] <= low + same) result.push_back(root);
  return result;
}

} // namespace

Retreating_part::Retreating_part(const Part_mesh& mesh, const Eigen::Matrix3d& axes, const Roots& roots)
    : mesh_(mesh), root_(mean(roots))
{
  const Part_box box{box_along(mesh.points, axes)};
  const auto projection = [&](int axis) -> Eigen::Matrix3d {
    return box.axes.col(axis) * box.axes.col(axis).transpose();
  };
  if (box.is_rod() && box.has_roots_at(roots, -1) && box.has_roots_at(roots, 1)) {
    vanishing_ -= projection(0);
    return;
  }
  // What is carried at several ends grows upwards, or from the back
  const Roots low = lowest(roots, 1);
  for (const Roots& some : {roots, low, lowest(low, 2)})
    if (const std::optional<int> axis = box.retreat(some)) {
      root_ = mean(some);
      vanishing_ = projection(*axis);
      return;
    }
}

/// Of the way from the root.
Eigen::Matrix3d Retreating_part::scale(double remaining) const
{
  constexpr double little = 0.3;
  const Eigen::Matrix3d others = Eigen::Matrix3d::Identity() - vanishing_;
  return remaining * vanishing_ + std::min(1., remaining / little) * others;
}

Point Retreating_part::place(const Point& p, double remaining) const
{
  return remaining >= 1 ? p : Point(root_ + scale(remaining) * (p - root_));
}

Points Retreating_part::points(double remaining) const
{
  if (remaining >= 1) return mesh_.points;
  return (scale(remaining) * (mesh_.points.colwise() - root_)).colwise() + root_;
}

} // namespace CGAL::Shape_correspondence::internal

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Retreating_part.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <vector>

namespace CGAL::Shape_correspondence::internal {
namespace {

using Roots = std::vector<Point>;

Point mean(const Roots& roots)
{
  return std::accumulate(roots.begin(), roots.end(), Point(Point::Zero())) / double(roots.size());
}

/// The box around a part along its axes, the longest one first.
struct Part_box
{
  Part_box(const Points& surface, const Eigen::Matrix3d& axes)
  {
    const Points turned = axes.transpose() * surface;
    const Point low = turned.rowwise().minCoeff(), high = turned.rowwise().maxCoeff();
    std::array<int, 3> order = {0, 1, 2};
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return high[a] - low[a] > high[b] - low[b]; });
    for (int i = 0; i < 3; ++i) {
      directions.col(i) = axes.col(order[std::size_t(i)]);
      half[i] = (high[order[std::size_t(i)]] - low[order[std::size_t(i)]]) / 2;
    }
    middle = axes * (low + high) / 2;
  }

  /// On which side of the middle along an axis all roots are; 0 if on none, or on both.
  int side(const Roots& roots, int axis) const
  {
    constexpr double aside = 0.3; // of the half extent
    int result = 0;
    for (const Point& root : roots) {
      const double at = directions.col(axis).dot(root - middle);
      const int side = std::abs(at) < aside * half[axis] ? 0 : at < 0 ? -1 : 1;
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

  bool is_rod() const { return half[1] <= rod * half[0]; }

  /// Whether there are roots at an end of the longest axis, -1 or 1.
  bool has_roots_at(const Roots& roots, int end) const
  {
    return std::any_of(roots.begin(), roots.end(), [&](const Point& root) { return side({root}, 0) == end; });
  }

  /// Whether points are spread along an axis, over much of the part.
  bool is_spanned(const Roots& roots, int axis) const
  {
    constexpr double much = 0.5; // of the extent
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Point& root : roots) {
      const double at = directions.col(axis).dot(root);
      low = std::min(low, at);
      high = std::max(high, at);
    }
    return high - low > much * 2 * half[axis];
  }

  static constexpr double rod = 0.3; ///< the most of its middle extent over the longest
  Eigen::Matrix3d directions;
  Point half, middle;
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

Retreating_part::Retreating_part(const Part_mesh& mesh, const Eigen::Matrix3d& axes, const Roots& roots,
                                 const Roots& joints)
    : mesh_(mesh), staying_(Eigen::Matrix3d::Zero())
{
  const Part_box box(mesh.points, axes);
  if (!joints.empty()) { // thins across the ways between its joints, and never to a point
    for (int axis = 0; axis < 2; ++axis)
      if (box.is_spanned(joints, axis)) staying_ += box.directions.col(axis) * box.directions.col(axis).transpose();
    thins_ = !staying_.isZero();
    if (thins_) {
      root_ = mean(joints);
      vanishing_ = Eigen::Matrix3d::Identity() - staying_;
      return;
    }
  }
  const Roots low =
      lowest(roots, 1); // what is carried at several ends grows upwards, or from the back, unless it is a rod
  const bool spans = box.is_rod() && box.has_roots_at(roots, -1) && box.has_roots_at(roots, 1);
  if (!spans)
    for (const Roots& some : {roots, low, lowest(low, 2)})
      if (const std::optional<int> axis = box.retreat(some)) {
        root_ = mean(some);
        vanishing_ = box.directions.col(*axis) * box.directions.col(*axis).transpose();
        return;
      }
  root_ = mean(roots);
  thins_ = box.has_roots_at(roots, -1) || box.has_roots_at(roots, 1);
  if (thins_) staying_ = box.directions.col(0) * box.directions.col(0).transpose();
  vanishing_ = Eigen::Matrix3d::Identity() - staying_;
}

/// Of the way from the root.
Eigen::Matrix3d Retreating_part::scale(double remaining) const
{
  constexpr double little = 0.3;
  const Eigen::Matrix3d others = Eigen::Matrix3d::Identity() - vanishing_ - staying_;
  const double left = thins_ ? std::cbrt(remaining) : remaining; // quickly out of what would be as thin as a hair
  return left * vanishing_ + std::min(1., remaining / little) * others + staying_;
}

Point Retreating_part::place(const Point& p, double remaining) const { return root_ + scale(remaining) * (p - root_); }

Points Retreating_part::points(double remaining) const
{
  if (remaining >= 1) return mesh_.points;
  return (scale(remaining) * (mesh_.points.colwise() - root_)).colwise() + root_;
}

} // namespace CGAL::Shape_correspondence::internal

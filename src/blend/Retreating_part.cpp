// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Retreating_part.h"

#include "blend/Rest_surface.h"
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

  /// How far points are spread along an axis, over the extent of the part.
  double spread(const Roots& points, int axis) const
  {
    constexpr double no_extent = 1e-6; // of the height
    const auto at = [&](const Point& a, const Point& b) { return axes.col(axis).dot(a) < axes.col(axis).dot(b); };
    const auto [low, high] = std::minmax_element(points.begin(), points.end(), at);
    return low == points.end() ? 0 : axes.col(axis).dot(*high - *low) / std::max(extents[axis], no_extent);
  }

  /// The axes along which points are spread most, two at most; of a rod at most its length.
  std::vector<int> spanned(const Roots& points) const
  {
    constexpr double much = 0.2; // of the extent; places are midway between the middles of parts
    std::vector<std::pair<double, int>> order;
    for (int axis = 0; axis < (is_rod() ? 1 : 3); ++axis)
      if (const double share = spread(points, axis); share > much) order.emplace_back(-share, axis);
    std::sort(order.begin(), order.end());
    std::vector<int> result;
    for (std::size_t i = 0; i < std::min<std::size_t>(2, order.size()); ++i)
      result.push_back(order[i].second);
    std::sort(result.begin(), result.end());
    return result;
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

/// Whether a part that thins would be seen to vanish: it is wide, and has about the surface of the box around it,
/// unlike a frame, a ring or a bent rod.
bool is_large(const Part_mesh& mesh, const Part_box& box)
{
  constexpr double wide = 0.04; // of the squared height
  constexpr double much = 0.6;  // of the surface of the box
  const Point e = box.extents;
  const double of_box = 2 * (e[0] * e[1] + e[1] * e[2] + e[0] * e[2]);
  return e[0] * e[1] > wide && Rest_surface(mesh.points, mesh.triangles).extent().area > much * of_box;
}

/// Whether a part is long and thin, if bent.
bool is_bar(const Part_chart& chart)
{
  const Point half = chart.half_extents();
  return !chart.is_sheet() && half.tail<2>().maxCoeff() <= Part_box::rod * half[0];
}

} // namespace

Retreating_part::Retreating_part(const Part_mesh& mesh, const Part_chart* chart, const Eigen::Matrix3d& axes,
                                 const Roots& carried_at, const Roots& joints)
    : mesh_(mesh), staying_(Eigen::Matrix3d::Zero())
{
  const Part_box box{box_along(mesh.points, axes)};
  const auto thin = [&](const std::vector<int>& along) {
    for (int axis : along)
      staying_ += box.axes.col(axis) * box.axes.col(axis).transpose();
    if (chart && along == (chart->is_sheet() ? std::vector<int>{0, 1} : std::vector<int>{0})) chart_ = *chart;
    ends_.resize(3, mesh.points.cols());
    for (Eigen::Index i = 0; i < ends_.cols(); ++i)
      ends_.col(i) = end_of(mesh.points.col(i));
  };
  const std::vector<int> between = box.spanned(joints);
  if (!between.empty() && !(between.size() == 2 && is_large(mesh, box))) {
    root_ = mean(joints);
    thin(between);
    return;
  }
  const Roots& roots = between.empty() ? carried_at : joints;
  // What is carried at several ends, or joined all around, grows upwards, or from the back, unless it is a rod
  const Roots low = lowest(roots, 1);
  const bool spans =
      (box.is_rod() || (chart && is_bar(*chart))) && box.has_roots_at(roots, -1) && box.has_roots_at(roots, 1);
  if (!spans)
    for (const Roots& some : {roots, low, lowest(low, 2)})
      if (const std::optional<int> axis = box.retreat(some)) {
        root_ = mean(some);
        vanishing_ = box.axes.col(*axis) * box.axes.col(*axis).transpose();
        return;
      }
  root_ = mean(roots);
  if (box.has_roots_at(roots, -1) || box.has_roots_at(roots, 1)) {
    thin({0});
  } else {
    vanishing_ = Eigen::Matrix3d::Identity();
  }
}

/// Of the way from the root, of what does not thin.
Eigen::Matrix3d Retreating_part::scale(double remaining) const
{
  constexpr double little = 0.3;
  const Eigen::Matrix3d others = Eigen::Matrix3d::Identity() - vanishing_;
  return remaining * vanishing_ + std::min(1., remaining / little) * others;
}

/// Where a point goes of what thins.
Point Retreating_part::end_of(const Point& p) const
{
  if (!chart_) return root_ + staying_ * (p - root_);
  Point k = chart_->coordinates(p);
  k.tail(chart_->is_sheet() ? 1 : 2).setZero();
  return (*chart_)(k);
}

// By the cube root: quickly out of what would be as thin as a hair
Point Retreating_part::place(const Point& p, double remaining) const
{
  if (remaining >= 1) return p;
  if (ends_.cols() == 0) return root_ + scale(remaining) * (p - root_);
  const Point end = end_of(p);
  return end + std::cbrt(remaining) * (p - end);
}

Points Retreating_part::points(double remaining) const
{
  if (remaining >= 1) return mesh_.points;
  if (ends_.cols() == 0) return (scale(remaining) * (mesh_.points.colwise() - root_)).colwise() + root_;
  return ends_ + std::cbrt(remaining) * (mesh_.points - ends_);
}

} // namespace CGAL::Shape_correspondence::internal

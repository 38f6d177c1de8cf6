// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/pair_boxes.h"

#include "base/quantized.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace CGAL::Shape_correspondence::internal {
namespace {

Point extents_along(const Points& surface, const Eigen::Matrix3d& axes)
{
  const Points local = axes.transpose() * surface;
  return local.rowwise().maxCoeff() - local.rowwise().minCoeff();
}

/// Those of the world, or the surface's own ones if the box along them is much smaller.
Eigen::Matrix3d box_axes(const Points& surface, const Eigen::Matrix3d& own_axes)
{
  constexpr double much = 0.45; // a square that is turned by 45 degrees needs none
  const auto volume = [&](const Eigen::Matrix3d& axes) {
    return extents_along(surface, axes).cwiseMax(2 * Part_chart::least_half_extent).prod();
  };
  const Eigen::Matrix3d world = Eigen::Matrix3d::Identity();
  return volume(own_axes) < much * volume(world) ? own_axes : world;
}

double angle_of(const Eigen::Matrix3d& rotation) { return std::acos(std::clamp((rotation.trace() - 1) / 2, -1., 1.)); }

/// Whether both boxes are as long along one axis as along another: what is in them may be round.
bool are_square(const std::array<Point, 2>& extents, int axis, int other)
{
  constexpr double alike = 1.15; // how many times as long, at most
  return std::all_of(extents.begin(), extents.end(),
                     [&](const Point& e) { return e[axis] < alike * e[other] && e[other] < alike * e[axis]; });
}

/// Charts with the longest axis of both boxes as the first and the shortest as the last one; but those of round things
/// that are no plates, such as shades of lamps, along the axis that they turn about.
Pair_charts charts_along(const std::array<const Points*, 2>& surfaces, std::array<Eigen::Matrix3d, 2> axes)
{
  constexpr double flat = 0.3; // the shortest extent over the middle one
  const std::array<Point, 2> extents = {extents_along(*surfaces[0], axes[0]), extents_along(*surfaces[1], axes[1])};
  const Point sum = extents[0] + extents[1];
  std::array<int, 3> order = {0, 1, 2};
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return quantized(sum[a]) > quantized(sum[b]); });
  const bool are_plates = sum[order[2]] < flat * sum[order[1]];
  if (!are_plates && are_square(extents, order[0], order[1]))
    std::rotate(order.begin(), order.begin() + 2, order.end());
  Eigen::Matrix3d turn = Eigen::Matrix3d::Zero();
  for (int i = 0; i < 3; ++i)
    turn(order[std::size_t(i)], i) = 1;
  if (turn.determinant() < 0) turn.col(2) *= -1;
  const auto chart = [&](std::size_t end) {
    const Eigen::Matrix3d turned = axes[end] * turn;
    return are_plates ? Part_chart::plate(*surfaces[end], turned) : Part_chart::box(*surfaces[end], turned);
  };
  return {chart(0), chart(1)};
}

} // namespace

Pair_charts pair_boxes(const std::array<const Points*, 2>& surfaces, const std::array<Eigen::Matrix3d, 2>& own_axes)
{
  const Eigen::Matrix3d from = box_axes(*surfaces[0], own_axes[0]), to = box_axes(*surfaces[1], own_axes[1]);
  const Point extents = extents_along(*surfaces[0], from), other_extents = extents_along(*surfaces[1], to);
  Eigen::Matrix3d best = to;
  std::tuple<Steps, Steps> least(std::numeric_limits<Steps>::max(), 0);
  for (const Eigen::Matrix3d& rotation : cube_rotations()) {
    const Eigen::Matrix3d turned = to * rotation;
    const Point difference = extents - (rotation.transpose() * other_extents).cwiseAbs();
    const std::tuple<Steps, Steps> cost(quantized(angle_of(turned * from.transpose())), quantized(difference.norm()));
    if (cost < least) least = cost, best = turned;
  }
  return charts_along(surfaces, {from, best});
}

double turn(const Pair_charts& charts) { return angle_of(charts.target.axes() * charts.source.axes().transpose()); }

double needless_turn(const Pair_charts& charts)
{
  double least = turn(charts);
  for (const Eigen::Matrix3d& rotation : cube_rotations())
    least = std::min(least, angle_of(charts.target.axes() * rotation * charts.source.axes().transpose()));
  return turn(charts) - least;
}

} // namespace CGAL::Shape_correspondence::internal

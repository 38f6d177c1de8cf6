// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Growth.h"

#include "base/quantized.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <tuple>

namespace CGAL::Shape_correspondence::internal {

Growth::Growth(const Part_chart& chart, const Points& points, const std::vector<Point>& holds)
    : chart_(chart), points_(points), coordinates_(3, points.cols()), offsets_(3, points.cols())
{
  constexpr double near = 0.25; // distance along the axis, in coordinates, up to which two places become one
  // Half extents, over the height and over that along the axis, up to which the line runs in the middle of the part
  constexpr double thin = 0.03, slender = 0.2;
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Point k = chart.coordinates(points.col(i));
    coordinates_.col(i) = k;
    offsets_.col(i) = chart.frame(k).inverse() * (points.col(i) - chart(k));
  }
  const Point half = chart.half_extents();
  Eigen::AlignedBox3d box;
  std::vector<Point> sorted;
  for (const Point& hold : holds) {
    sorted.push_back(chart.coordinates(hold));
    box.extend(sorted.back());
  }
  box.sizes().cwiseProduct(half).maxCoeff(&axis_);
  for (Point& station : sorted)
    for (int i = 0; i < 3; ++i)
      if (i != axis_ && half[i] <= std::min(thin, slender * half[axis_])) station[i] = 0;
  const auto key = [&](const Point& station) {
    const Point p = chart(station);
    return std::tuple(quantized(p.y()), quantized(p.z()));
  };
  std::sort(sorted.begin(), sorted.end(), [&](const Point& a, const Point& b) {
    return std::tuple(quantized(a[axis_]), key(a)) < std::tuple(quantized(b[axis_]), key(b));
  });
  for (const Point& station : sorted)
    if (stations_.empty() || station[axis_] - stations_.back()[axis_] > near)
      stations_.push_back(station);
    else if (key(station) < key(stations_.back()))
      stations_.back() = station;
    else if (!(key(stations_.back()) < key(station)))
      stations_.back() = (stations_.back() + station) / 2; // the two are mirror images
}

/// The place on the line from which the points at a coordinate along the axis grow.
Point Growth::from(double at) const
{
  const auto next =
      std::find_if(stations_.begin(), stations_.end(), [&](const Point& station) { return station[axis_] >= at; });
  if (next == stations_.begin()) return *next;
  const Point& last = *(next - 1);
  if (next == stations_.end()) return last;
  const double share = (at - last[axis_]) / ((*next)[axis_] - last[axis_]);
  return (1 - share) * last + share * *next;
}

Points Growth::points(double share) const
{
  constexpr double thick = 0.3; // share grown from which a part has its full thickness
  if (share >= 1) return points_;
  Points result(3, points_.cols());
  for (Eigen::Index i = 0; i < result.cols(); ++i) {
    const Point k = coordinates_.col(i), first = from(k[axis_]), now = first + share * (k - first);
    result.col(i) = chart_(now) + chart_.frame(now) * (std::min(1., share / thick) * offsets_.col(i));
  }
  return result;
}

} // namespace CGAL::Shape_correspondence::internal

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Growth.h"

#include "base/quantized.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>

namespace CGAL::Shape_correspondence::internal {

Growth::Growth(const Part_chart& chart, const Points& points, const std::vector<Hold>& holds)
    : chart_(chart), points_(points), coordinates_(3, points.cols()), offsets_(3, points.cols())
{
  constexpr double near = 0.25; // distance along the axis, in coordinates, of places of which one stays
  // Half extent, over the height and over that along the axis, up to which the line is in the middle of the part
  constexpr double thin = 0.03, slender = 0.2;
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Point k = chart.coordinates(points.col(i));
    coordinates_.col(i) = k;
    offsets_.col(i) = chart.frame(k).inverse() * (points.col(i) - chart(k));
  }
  const Point half = chart.half_extents();
  Eigen::AlignedBox3d box;
  std::vector<Station> sorted;
  for (const Hold& hold : holds) {
    sorted.push_back({chart.coordinates(hold.place), {hold}});
    box.extend(sorted.back().at);
  }
  box.sizes().cwiseProduct(half).maxCoeff(&axis_);
  for (Station& station : sorted)
    for (int i = 0; i < 3; ++i)
      if (i != axis_ && half[i] <= std::min(thin, slender * half[axis_])) station.at[i] = 0;
  const auto key = [&](const Station& station) {
    const Point p = chart(station.at);
    return std::tuple(quantized(p.y()), quantized(p.z()));
  };
  std::sort(sorted.begin(), sorted.end(), [&](const Station& a, const Station& b) {
    return std::tuple(quantized(a.at[axis_]), key(a)) < std::tuple(quantized(b.at[axis_]), key(b));
  });
  for (Station& station : sorted) {
    if (stations_.empty() || station.at[axis_] - stations_.back().at[axis_] > near) {
      stations_.push_back(std::move(station));
      continue;
    }
    Station& last = stations_.back();
    if (key(station) < key(last))
      last.at = station.at;
    else if (!(key(last) < key(station)))
      last.at = (last.at + station.at) / 2; // mirror images
    last.holds.push_back(station.holds.front());
  }
}

Points Growth::ways(const std::function<Point(const Hold&)>& way_of) const
{
  std::vector<std::optional<Point>> known; // by station, the mean way of what holds it
  std::vector<std::size_t> which;
  for (std::size_t i = 0; i < stations_.size(); ++i) {
    Eigen::Vector4d sum = Eigen::Vector4d::Zero();
    for (const Hold& hold : stations_[i].holds) {
      if (hold.by == Hold::By::MATCHED) sum[3] += 1;
      if (hold.by == Hold::By::CARRIER) sum += way_of(hold).homogeneous();
    }
    known.emplace_back();
    if (sum[3] > 0) known[i] = sum.hnormalized(), which.push_back(i);
  }
  Points result = Points::Zero(3, Eigen::Index(stations_.size()));
  for (std::size_t i = 0; i < stations_.size() && !which.empty(); ++i) {
    const auto next = std::lower_bound(which.begin(), which.end(), i);
    const std::size_t after = next == which.end() ? which.back() : *next,
                      before = next == which.begin() || *next == i ? after : *(next - 1);
    const double whole = stations_[after].at[axis_] - stations_[before].at[axis_],
                 share = whole > 0 ? (stations_[i].at[axis_] - stations_[before].at[axis_]) / whole : 0;
    Point way = (1 - share) * *known[before] + share * *known[after];
    const auto& holds = stations_[i].holds;
    if (std::any_of(holds.begin(), holds.end(), [](const Hold& hold) { return hold.by == Hold::By::GROUND; }))
      way.y() = 0;
    result.col(Eigen::Index(i)) = way;
  }
  return result.isZero(0) ? Points() : result;
}

/// Interpolates a value of stations at a place along the axis.
template <typename Value>
Point Growth::along(double at, const Value& value) const
{
  const auto next =
      std::find_if(stations_.begin(), stations_.end(), [&](const Station& station) { return station.at[axis_] >= at; });
  if (next == stations_.begin()) return value(0);
  const auto after = Eigen::Index(next - stations_.begin());
  if (next == stations_.end()) return value(after - 1);
  const double from = (next - 1)->at[axis_], share = (at - from) / (next->at[axis_] - from);
  return (1 - share) * value(after - 1) + share * value(after);
}

Point Growth::grown(const Point& k, const Point& offset, double share, const Points& ways) const
{
  constexpr double thick = 0.3; // share grown from which a part has its full thickness
  const Point from = along(k[axis_], [&](Eigen::Index i) { return stations_[std::size_t(i)].at; }),
              now = from + share * (k - from),
              p = chart_(now) + chart_.frame(now) * (std::min(1., share / thick) * offset);
  if (ways.cols() == 0) return p;
  return p + along(k[axis_], [&](Eigen::Index i) -> Point { return ways.col(i); });
}

Points Growth::points(double share, const Points& ways) const
{
  if (share >= 1 && ways.cols() == 0) return points_;
  Points result(3, points_.cols());
  for (Eigen::Index i = 0; i < result.cols(); ++i)
    result.col(i) = grown(coordinates_.col(i), offsets_.col(i), share, ways);
  return result;
}

Point Growth::way(const Point& p, double share, const Points& ways) const
{
  const Point k = chart_.coordinates(p);
  return grown(k, chart_.frame(k).inverse() * (p - chart_(k)), share, ways) - p;
}

} // namespace CGAL::Shape_correspondence::internal

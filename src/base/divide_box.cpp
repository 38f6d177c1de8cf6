// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/divide_box.h"

#include "base/quantized.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace CGAL::Shape_correspondence::internal {

namespace {

constexpr double apart = 0.25;        // least spread of centres that divides a box, over the largest extent of a share
constexpr double one_place = 0.15;    // largest extent of a cluster of centres at one position, over the spread
constexpr double least_extent = 1e-4; // lower bound of half extents, so that a flat share gets a box with volume

using Indices = std::vector<std::size_t>;

/// The axis along which the centres are spread most; -1 if the shares are concentric.
int axis_of_spread(const std::vector<Share>& shares, const Indices& of, double& spread)
{
  int axis = -1;
  spread = 0;
  for (int a = 0; a < 3; ++a) {
    double low = shares[of[0]].middle[a], high = low, extent = 0;
    for (std::size_t i : of) {
      low = std::min(low, shares[i].middle[a]);
      high = std::max(high, shares[i].middle[a]);
      extent = std::max(extent, 2 * shares[i].half[a]);
    }
    if (quantized(high - low) > quantized(spread) && high - low > apart * extent) axis = a, spread = high - low;
  }
  return axis;
}

void divide(const Eigen::AlignedBox3d& box, const std::vector<Share>& shares, Indices of,
            std::vector<Eigen::AlignedBox3d>& result)
{
  double spread = 0;
  const int axis = axis_of_spread(shares, of, spread);
  if (axis < 0) {
    for (std::size_t i : of)
      result[i] = box;
    return;
  }
  std::stable_sort(of.begin(), of.end(),
                   [&](std::size_t a, std::size_t b) { return shares[a].middle[axis] < shares[b].middle[axis]; });
  std::vector<Indices> clusters;
  for (std::size_t i : of) {
    if (clusters.empty() || shares[i].middle[axis] - shares[clusters.back().front()].middle[axis] > one_place * spread)
      clusters.emplace_back();
    clusters.back().push_back(i);
  }
  std::vector<double> ends{0};
  for (const Indices& cluster : clusters) {
    double extent = least_extent;
    for (std::size_t i : cluster)
      extent = std::max(extent, shares[i].half[axis]);
    ends.push_back(ends.back() + extent);
  }
  for (std::size_t c = 0; c < clusters.size(); ++c) {
    Eigen::AlignedBox3d part = box;
    const double low = box.min()[axis], extent = box.sizes()[axis] / ends.back();
    if (c > 0) part.min()[axis] = low + extent * ends[c];
    if (c + 1 < clusters.size()) part.max()[axis] = low + extent * ends[c + 1];
    divide(part, shares, std::move(clusters[c]), result);
  }
}

} // namespace

std::vector<Eigen::AlignedBox3d> divide_box(const Eigen::AlignedBox3d& box, const std::vector<Share>& shares)
{
  std::vector<Eigen::AlignedBox3d> result(shares.size(), box);
  Indices all(shares.size());
  std::iota(all.begin(), all.end(), std::size_t(0));
  if (all.size() > 1) divide(box, shares, std::move(all), result);
  return result;
}

} // namespace CGAL::Shape_correspondence::internal

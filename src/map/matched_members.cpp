// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "map/matched_members.h"

#include "base/Disjoint_sets.h"
#include "base/optimal_assignment.h"
#include "base/quantized.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

std::vector<Connected_parts> connected_parts(const Part_pairs& pairs, std::size_t sources, std::size_t targets)
{
  Disjoint_sets connected(sources + targets);
  for (const auto& [s, t] : pairs)
    connected.unite(s, sources + t);
  std::vector<Connected_parts> all(sources + targets), result;
  for (std::size_t i = 0; i < connected.size(); ++i)
    (i < sources ? all[connected[i]].source : all[connected[i]].target).push_back(i < sources ? i : i - sources);
  for (Connected_parts& sets : all)
    if (!sets.source.empty() && !sets.target.empty()) result.push_back(std::move(sets));
  return result;
}

namespace {

/// Relative positions of parts: their centres in the bounding box of all centres.
Points places(const Charted_shape& shape, const std::vector<std::size_t>& parts)
{
  constexpr double least_extent = 0.02; // ratio to the shape's height; along shorter extents, positions count as equal
  Points result(3, Eigen::Index(parts.size()));
  for (std::size_t i = 0; i < parts.size(); ++i)
    result.col(Eigen::Index(i)) = shape.charts[parts[i]](Point::Zero());
  const Point low = result.rowwise().minCoeff(), extent = result.rowwise().maxCoeff() - low;
  for (int axis = 0; axis < 3; ++axis) {
    if (extent[axis] < least_extent)
      result.row(axis).setConstant(0.5);
    else
      result.row(axis) = (result.row(axis).array() - low[axis]) / extent[axis];
  }
  return result;
}

/// Matches the parts of two sets by relative positions: by optimal assignment as far as their numbers allow; every
/// remaining part with the nearest one, or all about as near, so that symmetric sets are matched symmetrically.
Part_pairs matched_by_place(const Connected_parts& sets, const Charted_shape& source, const Charted_shape& target)
{
  constexpr double as_near = 0.02; // in units of the bounding box; tolerance for parts about as near as the nearest one
  // Weight of distances between the shapes, so that ties are not settled by the order of parts
  constexpr double tie = 1e-3;
  const Points from = places(source, sets.source), to = places(target, sets.target);
  Eigen::MatrixXd cost(from.cols(), to.cols());
  for (Eigen::Index i = 0; i < cost.rows(); ++i)
    for (Eigen::Index j = 0; j < cost.cols(); ++j) {
      const Point way = source.charts[sets.source[std::size_t(i)]](Point::Zero()) -
                        target.charts[sets.target[std::size_t(j)]](Point::Zero());
      cost(i, j) = double(quantized((from.col(i) - to.col(j)).norm() + tie * way.norm())) * comparison_grid;
    }
  const bool fewer_sources = cost.rows() <= cost.cols();
  if (!fewer_sources) cost.transposeInPlace();
  Part_pairs result;
  const auto add = [&](std::size_t row, std::size_t col) {
    result.emplace_back(sets.source[fewer_sources ? row : col], sets.target[fewer_sources ? col : row]);
  };
  std::vector<char> taken(std::size_t(cost.cols()), 0);
  const std::vector<std::size_t> first = optimal_assignment(cost);
  for (std::size_t row = 0; row < first.size(); ++row) {
    add(row, first[row]);
    taken[first[row]] = 1;
  }
  for (Eigen::Index col = 0; col < cost.cols(); ++col) {
    if (taken[std::size_t(col)]) continue;
    const double least = cost.col(col).minCoeff();
    for (Eigen::Index row = 0; row < cost.rows(); ++row)
      if (cost(row, col) <= least + as_near) add(std::size_t(row), std::size_t(col));
  }
  return result;
}

} // namespace

Part_pairs matched_members(const Charted_shape& source, const Charted_shape& target, const Part_pairs& pairs)
{
  Part_pairs result;
  for (const Connected_parts& sets : connected_parts(pairs, source.charts.size(), target.charts.size())) {
    if (sets.source.size() == 1 || sets.target.size() == 1) {
      for (std::size_t s : sets.source)
        for (std::size_t t : sets.target)
          result.emplace_back(s, t);
    } else {
      const Part_pairs matched = matched_by_place(sets, source, target);
      result.insert(result.end(), matched.begin(), matched.end());
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

} // namespace CGAL::Shape_correspondence::internal

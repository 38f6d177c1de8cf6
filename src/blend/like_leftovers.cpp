// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/like_leftovers.h"

#include "base/optimal_assignment.h"
#include "base/quantized.h"
#include "blend/Blend_part.h"
#include "blend/Blend_stage.h"
#include "blend/unlike_pairs.h"

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::internal {
namespace {

/// The parts of an end without a pair, and their boxes, in units of the box of the shape.
struct Leftovers
{
  std::vector<std::size_t> parts;
  std::vector<contacts::Box> boxes;
};

Leftovers leftovers(const Blend_stage& stage, std::size_t end, const Part_pairs& paired)
{
  std::vector<char> has_pair(stage.meshes[end].size(), 0);
  for (const auto& [source, target] : paired)
    has_pair[end == 0 ? source : target] = 1;
  const contacts::Box& whole = stage.boxes[end];
  const Point low = whole.min(), sizes = whole.sizes().cwiseMax(2 * Part_chart::least_half_extent);
  Leftovers result;
  for (std::size_t part = 0; part < has_pair.size(); ++part) {
    if (has_pair[part]) continue;
    const contacts::Box box = box_of(stage.meshes[end][part].points);
    result.parts.push_back(part);
    result.boxes.emplace_back((box.min() - low).cwiseQuotient(sizes), (box.max() - low).cwiseQuotient(sizes));
  }
  return result;
}

double difference(const contacts::Box& a, const contacts::Box& b)
{
  return (a.min() - b.min()).cwiseAbs().sum() + (a.max() - b.max()).cwiseAbs().sum();
}

bool are_alike(const contacts::Box& a, const contacts::Box& b)
{
  constexpr double most = 1;    // one side of six may be as far off as the whole shape is wide
  constexpr double near = 0.05; // of the whole shape: boxes that are no farther apart overlap
  return difference(a, b) <= most && a.exteriorDistance(b) <= near;
}

} // namespace

Part_pairs like_leftovers(const Blend_stage& stage, const Part_pairs& paired)
{
  constexpr double never = 100; // costs more than any difference saves
  Leftovers rows = leftovers(stage, 0, paired), columns = leftovers(stage, 1, paired);
  const bool is_swapped = rows.parts.size() > columns.parts.size();
  if (is_swapped) std::swap(rows, columns);
  Part_pairs result;
  if (rows.parts.empty()) return result;
  Eigen::MatrixXd cost(Eigen::Index(rows.parts.size()), Eigen::Index(columns.parts.size()));
  for (Eigen::Index i = 0; i < cost.rows(); ++i)
    for (Eigen::Index j = 0; j < cost.cols(); ++j) {
      const contacts::Box &a = rows.boxes[std::size_t(i)], &b = columns.boxes[std::size_t(j)];
      cost(i, j) =
          are_alike(a, b) && !are_unlike(stage, is_swapped ? columns.parts[std::size_t(j)] : rows.parts[std::size_t(i)],
                                         is_swapped ? rows.parts[std::size_t(i)] : columns.parts[std::size_t(j)])
              ? double(quantized(difference(a, b))) * comparison_grid
              : never;
    }
  const std::vector<std::size_t> assigned = optimal_assignment(cost);
  for (std::size_t i = 0; i < assigned.size(); ++i) {
    if (cost(Eigen::Index(i), Eigen::Index(assigned[i])) >= never) continue;
    const std::size_t a = rows.parts[i], b = columns.parts[assigned[i]];
    result.emplace_back(is_swapped ? b : a, is_swapped ? a : b);
  }
  return result;
}

} // namespace CGAL::Shape_correspondence::internal

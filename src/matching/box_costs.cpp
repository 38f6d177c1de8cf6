// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "matching/box_costs.h"
#include "base/quantized.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

namespace {

// Lengths in the unit box
constexpr double box_padding = 0.02;    // keeps the volume of flat boxes above 0
constexpr double extent_padding = 0.03; // under it, extents count as equal

constexpr double board_share = 0.5; // of the cost of ground contact, for boards: many reach down where others end above

constexpr double anchor_confidence = 0.2; // pairs above it bend one box onto the other
constexpr double warp_width = 0.15;       // standard deviation of their influence, in the unit box
constexpr double warp_inertia = 0.3;      // weight of staying in place

} // namespace

double cost_of_kind(const Part_extent& a, const Part_extent& b, const Part_cost_weights& weights)
{
  double result = weights.orientation * (a.orientation - b.orientation).norm();
  if (a.on_ground != b.on_ground) result += (a.is_board || b.is_board ? board_share : 1) * weights.ground;
  if (a.is_in_chain != b.is_in_chain) result += weights.chain;
  return result;
}

Eigen::MatrixXd costs_of_boxes(const Boxes& a, const Boxes& b, const Part_cost_weights& weights)
{
  const auto extents = [](const Boxes& boxes) -> Eigen::ArrayX3d { return (boxes.high - boxes.low).max(0.); };
  const Eigen::ArrayX3d a_extents = extents(a), b_extents = extents(b);
  const Eigen::ArrayXd a_volumes = (a_extents + box_padding).rowwise().prod();
  const Eigen::ArrayXd b_volumes = (b_extents + box_padding).rowwise().prod();
  const Eigen::ArrayX3d a_logs = (a_extents + extent_padding).log(), b_logs = (b_extents + extent_padding).log();

  Eigen::MatrixXd result(a.low.rows(), b.low.rows());
  for (Eigen::Index j = 0; j < result.cols(); ++j)
    for (Eigen::Index i = 0; i < result.rows(); ++i) {
      const double overlap =
          (a.high.row(i).min(b.high.row(j)) - a.low.row(i).max(b.low.row(j)) + box_padding).max(0.).prod();
      const Axes apart = ((a.low.row(i) + a.high.row(i)) - (b.low.row(j) + b.high.row(j))).abs().transpose() / 2;
      result(i, j) = weights.overlap * (1 - overlap / std::min(a_volumes[i], b_volumes[j])) +
                     weights.extent * (a_logs.row(i) - b_logs.row(j)).abs().sum() + weights.side * apart[0] +
                     weights.front * apart[2];
    }
  return result;
}

Eigen::ArrayXXd mutual_softmax(const Eigen::MatrixXd& costs)
{
  const Eigen::ArrayXXd likelihood = (-costs.array()).exp(), transposed = likelihood.transpose();
  const Eigen::VectorXd of_rows = likelihood.rowwise().sum(), of_columns = transposed.rowwise().sum();
  return likelihood / (of_rows * of_columns.transpose()).array().sqrt();
}

namespace {

// Ends of boxes and where they belong in the other shape.
struct Anchors
{
  Eigen::ArrayX3d from, to;
  Eigen::ArrayXd weights;
};

// Where the anchors pull the ends of boxes to: along each axis, the kernel-weighted mean of their displacements.
Eigen::ArrayX3d warped(const Eigen::ArrayX3d& ends, const Anchors& anchors)
{
  Eigen::ArrayX3d result = ends;
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::ArrayXd from = anchors.from.col(axis), displacement = anchors.to.col(axis) - from;
    const auto influence = [&](const Eigen::ArrayXd& at, double x) -> Eigen::ArrayXd {
      return anchors.weights * (-((at - x) / warp_width).square() / 2).exp();
    };
    for (Eigen::Index i = 0; i < ends.rows(); ++i) {
      const Eigen::ArrayXd near = influence(from, ends(i, axis));
      double pull = (near * displacement).sum(), weight = near.sum();
      if (axis == 0) { // what is true of the left side is true of the right one
        const Eigen::ArrayXd mirrored = influence(1 - from, ends(i, axis));
        pull -= (mirrored * displacement).sum();
        weight += mirrored.sum();
      }
      result(i, axis) += pull / (weight + warp_inertia);
    }
  }
  return result;
}

Boxes warped(const Boxes& boxes, const Anchors& anchors)
{
  return {warped(boxes.low, anchors), warped(boxes.high, anchors)};
}

Anchors anchors_of(const Boxes& a, const Boxes& b, const Eigen::MatrixXd& costs)
{
  const Eigen::ArrayXXd likely = mutual_softmax(costs);
  std::vector<std::pair<Eigen::Index, Eigen::Index>> pairs;
  for (Eigen::Index i = 0; i < costs.rows(); ++i)
    for (Eigen::Index j = 0; j < costs.cols(); ++j)
      if (quantized(likely(i, j)) > quantized(anchor_confidence)) pairs.emplace_back(i, j);

  const auto n = Eigen::Index(2 * pairs.size());
  Anchors result{Eigen::ArrayX3d(n, 3), Eigen::ArrayX3d(n, 3), Eigen::ArrayXd(n)};
  for (Eigen::Index k = 0; k < n; k += 2) {
    const auto& [i, j] = pairs[std::size_t(k / 2)];
    result.from.row(k) = a.low.row(i), result.from.row(k + 1) = a.high.row(i);
    result.to.row(k) = b.low.row(j), result.to.row(k + 1) = b.high.row(j);
    result.weights.segment(k, 2) = likely(i, j) / 2;
  }
  return result;
}

} // namespace

Eigen::MatrixXd costs_after_warping(const Boxes& a, const Boxes& b, const Eigen::MatrixXd& costs_of_kind,
                                    const Part_cost_weights& weights)
{
  const Eigen::MatrixXd given = costs_of_boxes(a, b, weights);
  const Anchors there = anchors_of(a, b, costs_of_kind + given), back{there.to, there.from, there.weights};
  const Eigen::MatrixXd source_warped = costs_of_boxes(warped(a, there), b, weights);
  const Eigen::MatrixXd target_warped = costs_of_boxes(a, warped(b, back), weights);
  return costs_of_kind + (given + (source_warped + target_warped)) / 3;
}

} // namespace CGAL::Shape_correspondence::internal

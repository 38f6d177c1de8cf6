// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "matching/box_costs.h"
#include "base/quantized.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

// Cost of what never corresponds: more than all other terms of a pair add up to.
constexpr double incompatible = 50;

double cost_of_kind(const Part_extent& a, const Part_extent& b, const Part_matching_options& options)
{
  const Part_cost_weights& weights = options.weights;
  double result = weights.orientation * (a.orientation - b.orientation).norm();
  // Of boards, many reach down where others end above
  if (a.on_ground != b.on_ground) result += (a.is_board || b.is_board ? 0.5 : 1) * weights.ground;
  if (a.is_in_chain != b.is_in_chain) result += incompatible;
  return result;
}

Eigen::MatrixXd costs_of_boxes(const Boxes& a, const Boxes& b, const Part_matching_options& options)
{
  const Part_cost_weights& weights = options.weights;
  const double tolerance = options.tolerance;
  const auto extents = [](const Boxes& boxes) -> Eigen::ArrayX3d { return (boxes.high - boxes.low).max(0.); };
  const Eigen::ArrayX3d a_extents = extents(a), b_extents = extents(b);
  const Eigen::ArrayXd a_volumes = (a_extents + tolerance).rowwise().prod();
  const Eigen::ArrayXd b_volumes = (b_extents + tolerance).rowwise().prod();
  const Eigen::ArrayX3d a_logs = (a_extents + tolerance).log(), b_logs = (b_extents + tolerance).log();

  Eigen::MatrixXd result(a.low.rows(), b.low.rows());
  for (Eigen::Index j = 0; j < result.cols(); ++j)
    for (Eigen::Index i = 0; i < result.rows(); ++i) {
      const double overlap =
          (a.high.row(i).min(b.high.row(j)) - a.low.row(i).max(b.low.row(j)) + tolerance).max(0.).prod();
      const Axes apart = ((a.low.row(i) + a.high.row(i)) - (b.low.row(j) + b.high.row(j))).abs().transpose() / 2;
      result(i, j) = weights.overlap * (1 - overlap / std::min(a_volumes[i], b_volumes[j])) +
                     weights.extent * (a_logs.row(i) - b_logs.row(j)).abs().sum() +
                     weights.place * (apart[0] + apart[2]);
    }
  return result;
}

namespace {

// How likely parts are to correspond, going by either of them: geometric mean of the two softmaxes. Sums run along rows
// both times: with the shapes swapped, the same bits.
Eigen::ArrayXXd mutual_softmax(const Eigen::MatrixXd& costs)
{
  const Eigen::ArrayXXd likelihood = (-costs.array()).exp(), transposed = likelihood.transpose();
  const Eigen::VectorXd of_rows = likelihood.rowwise().sum(), of_columns = transposed.rowwise().sum();
  return likelihood / (of_rows * of_columns.transpose()).array().sqrt();
}

// Ends of boxes and where they belong in the other shape.
struct Anchors
{
  Eigen::ArrayX3d from, to;
  Eigen::ArrayXd weights;
};

// Where the anchors pull the ends of boxes to: along each axis, the kernel-weighted mean of their displacements and of
// none, which weighs `inertia`.
Eigen::ArrayX3d warped(const Eigen::ArrayX3d& ends, const Anchors& anchors, double width, double inertia)
{
  Eigen::ArrayX3d result = ends;
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::ArrayXd from = anchors.from.col(axis), displacement = anchors.to.col(axis) - from;
    for (Eigen::Index i = 0; i < ends.rows(); ++i) {
      const Eigen::ArrayXd influence = anchors.weights * (-((from - ends(i, axis)) / width).square() / 2).exp();
      result(i, axis) += (influence * displacement).sum() / (influence.sum() + inertia);
    }
  }
  return result;
}

Boxes warped(const Boxes& boxes, const Anchors& anchors, double width, double inertia)
{
  return {warped(boxes.low, anchors, width, inertia), warped(boxes.high, anchors, width, inertia)};
}

Anchors anchors_of(const Boxes& a, const Boxes& b, const Eigen::MatrixXd& costs, double least_likelihood)
{
  const Eigen::ArrayXXd likely = mutual_softmax(costs);
  std::vector<std::pair<Eigen::Index, Eigen::Index>> pairs;
  for (Eigen::Index i = 0; i < costs.rows(); ++i)
    for (Eigen::Index j = 0; j < costs.cols(); ++j)
      if (quantized(likely(i, j)) > quantized(least_likelihood)) pairs.emplace_back(i, j);

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
                                    const Part_matching_options& options)
{
  const Eigen::MatrixXd given = costs_of_boxes(a, b, options);
  const Anchors there = anchors_of(a, b, costs_of_kind + given, options.anchor),
                back{there.to, there.from, there.weights};
  const Eigen::MatrixXd source_warped =
      costs_of_boxes(warped(a, there, options.warp_width, options.anchor), b, options);
  const Eigen::MatrixXd target_warped = costs_of_boxes(a, warped(b, back, options.warp_width, options.anchor), options);
  return costs_of_kind + (given + (source_warped + target_warped)) / 3;
}

} // namespace CGAL::Shape_correspondence::internal

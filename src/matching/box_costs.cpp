// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "matching/box_costs.h"
#include "base/quantized.h"

#include <array>
#include <cstddef>
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

Measured_boxes::Measured_boxes(const Boxes& boxes, double tolerance) : Boxes(boxes)
{
  const Eigen::ArrayX3d extents = (high - low).max(0.) + tolerance;
  volumes = extents.rowwise().prod();
  logs = extents.log();
}

// Column by column, so that the boxes of one shape are taken several at once.
Eigen::MatrixXd costs_of_boxes(const Measured_boxes& a, const Measured_boxes& b, const Part_matching_options& options)
{
  const Part_cost_weights& weights = options.weights;
  const double tolerance = options.tolerance;
  Eigen::MatrixXd result(a.low.rows(), b.low.rows());
  for (Eigen::Index j = 0; j < result.cols(); ++j) {
    const Axes low = b.low.row(j), high = b.high.row(j), sum = low + high, logs = b.logs.row(j);
    const auto overlap = [&](int axis) {
      return (a.high.col(axis).min(high[axis]) - a.low.col(axis).max(low[axis]) + tolerance).max(0.);
    };
    const auto stretch = [&](int axis) { return (a.logs.col(axis) - logs[axis]).abs(); };
    const auto apart = [&](int axis) { return ((a.low.col(axis) + a.high.col(axis)) - sum[axis]).abs() / 2; };
    result.col(j) = (weights.overlap * (1 - overlap(0) * (overlap(1) * overlap(2)) / a.volumes.min(b.volumes[j])) +
                     weights.extent * (stretch(0) + (stretch(1) + stretch(2))) + weights.place * (apart(0) + apart(2)))
                        .matrix();
  }
  return result;
}

namespace {

constexpr Eigen::Index most_kept_parts = 128; // 96 bytes for each pair of parts

// \param others an even number of ends: the exponential of a scalar has other bits than that of a vector
template <typename Ends>
auto closeness_to(const Ends& others, double end, double width)
{
  return (-((others - end) / width).square() / 2).exp();
}

} // namespace

Closeness::Closeness(const Boxes& boxes, double width) : width_(width)
{
  const Eigen::Index parts = boxes.low.rows(), n = 2 * parts;
  for (int axis = 0; axis < 3; ++axis) {
    Eigen::ArrayXd& ends = ends_[std::size_t(axis)];
    ends.resize(n);
    for (Eigen::Index part = 0; part < parts; ++part) {
      ends[2 * part] = boxes.low(part, axis);
      ends[2 * part + 1] = boxes.high(part, axis);
    }
    if (parts > most_kept_parts) continue;
    Eigen::MatrixXd& kept = kept_[std::size_t(axis)];
    kept.resize(n, n);
    for (Eigen::Index end = 0; end < n; ++end) {
      const Eigen::Index rest = n - end / 2 * 2;
      kept.col(end).tail(rest) = closeness_to(ends.tail(rest), ends[end], width).matrix();
      for (Eigen::Index other = end + 1; other < n; ++other)
        kept(end, other) = kept(other, end);
    }
  }
}

const double* Closeness::of_end(int axis, Eigen::Index end, Eigen::ArrayXd& room) const
{
  const Eigen::MatrixXd& kept = kept_[std::size_t(axis)];
  if (kept.size() > 0) return kept.col(end).data();
  const Eigen::ArrayXd& ends = ends_[std::size_t(axis)];
  room = closeness_to(ends, ends[end], width_);
  return room.data();
}

namespace {

// Likelihood of correspondence: geometric mean of the softmaxes over rows and over columns. Sums run along rows both
// times, for the same bits with the shapes swapped.
Eigen::ArrayXXd mutual_softmax(const Eigen::MatrixXd& costs)
{
  const Eigen::ArrayXXd likelihood = (-costs.array()).exp(), transposed = likelihood.transpose();
  const Eigen::VectorXd of_rows = likelihood.rowwise().sum(), of_columns = transposed.rowwise().sum();
  return likelihood / (of_rows * of_columns.transpose()).array().sqrt();
}

// Pairs of parts whose boxes pull each other in a warp.
struct Anchors
{
  std::array<std::vector<Eigen::Index>, 2> parts;
  std::vector<double> weights;
};

Anchors anchors_of(const Eigen::MatrixXd& costs, double least_likelihood)
{
  const Eigen::ArrayXXd likely = mutual_softmax(costs);
  const long least = quantized(least_likelihood);
  Anchors result;
  for (Eigen::Index i = 0; i < costs.rows(); ++i)
    for (Eigen::Index j = 0; j < costs.cols(); ++j) {
      if (quantized(likely(i, j)) <= least) continue;
      result.parts[0].push_back(i);
      result.parts[1].push_back(j);
      result.weights.push_back(likely(i, j) / 2);
    }
  return result;
}

// The boxes of one of the shapes, numbered `side`, after the anchors pulled their ends towards those of the other:
// along each axis by the mean of the displacements, weighted by closeness, and of none, which weighs `inertia`.
Boxes warped(const Boxes& boxes, const Closeness& closeness, const Boxes& others, const Anchors& anchors,
             std::size_t side, double inertia)
{
  const std::vector<Eigen::Index>&own = anchors.parts[side], &other = anchors.parts[1 - side];
  const auto count = Eigen::Index(own.size());
  Eigen::ArrayXd displacement(2 * count), influence(2 * count), room;
  Boxes result = boxes;
  for (int axis = 0; axis < 3; ++axis) {
    for (Eigen::Index k = 0; k < count; ++k) {
      const Eigen::Index i = own[std::size_t(k)], j = other[std::size_t(k)];
      displacement[2 * k] = others.low(j, axis) - boxes.low(i, axis);
      displacement[2 * k + 1] = others.high(j, axis) - boxes.high(i, axis);
    }
    for (Eigen::Index end = 0; end < 2 * boxes.low.rows(); ++end) {
      const double* const near = closeness.of_end(axis, end, room);
      for (Eigen::Index k = 0; k < count; ++k) {
        const Eigen::Index low = 2 * own[std::size_t(k)];
        influence[2 * k] = anchors.weights[std::size_t(k)] * near[low];
        influence[2 * k + 1] = anchors.weights[std::size_t(k)] * near[low + 1];
      }
      (end % 2 == 0 ? result.low : result.high)(end / 2, axis) +=
          (influence * displacement).sum() / (influence.sum() + inertia);
    }
  }
  return result;
}

} // namespace

Eigen::MatrixXd costs_after_warping(const Normalized_shape& a, const Normalized_shape& b,
                                    const Eigen::MatrixXd& costs_of_kind, const Part_matching_options& options)
{
  const Eigen::MatrixXd given = costs_of_boxes(a.boxes, b.boxes, options);
  const Anchors anchors = anchors_of(costs_of_kind + given, options.anchor);
  const Boxes warped_a = warped(a.boxes, a.closeness, b.boxes, anchors, 0, options.anchor),
              warped_b = warped(b.boxes, b.closeness, a.boxes, anchors, 1, options.anchor);
  return costs_of_kind + (given + (costs_of_boxes(Measured_boxes(warped_a, options.tolerance), b.boxes, options) +
                                   costs_of_boxes(a.boxes, Measured_boxes(warped_b, options.tolerance), options))) /
                             3;
}

} // namespace CGAL::Shape_correspondence::internal

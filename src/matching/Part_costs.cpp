// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "matching/Part_costs.h"
#include "base/quantized.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence {
using namespace internal;

namespace {

// Cost of a pair that never corresponds; greater than the sum of all other costs of a pair.
constexpr double incompatible = 50;

// The costs that do not depend on positions.
double cost_of_kind(const Part_extent& a, const Part_extent& b, const Part_matching_options& options)
{
  const Part_cost_weights& weights = options.weights;
  double result = weights.orientation * (a.orientation - b.orientation).norm();
  // Weighed less for boards: many boards reach the ground where their counterparts end above it
  if (a.on_ground != b.on_ground) result += (a.is_board || b.is_board ? 0.5 : 1) * weights.ground;
  if (a.is_in_chain != b.is_in_chain) result += incompatible;
  return result;
}

bool compares_features(const Shape_features& a, const Shape_features& b, const Part_matching_options& options)
{
  if (options.weights.features == 0 || a.learned.size() == 0 || b.learned.size() == 0) return false;
  if (const auto [less, more] = std::minmax({a.learned.rows(), b.learned.rows()}); less < more)
    throw Invalid_input("the features of one shape have " + std::to_string(less) + " dimensions, those of the other " +
                        std::to_string(more) + "; give both those of the same network");
  return true;
}

// The weighted cosine distance of features, which are given as vectors of length 1 at most.
double cost_of_features(const Eigen::MatrixXd& a, std::size_t i, const Eigen::MatrixXd& b, std::size_t j,
                        const Part_matching_options& options)
{
  const double cosine = a.col(Eigen::Index(i)).dot(b.col(Eigen::Index(j)));
  return options.weights.features * (1 - std::clamp(cosine, -1., 1.));
}

// The costs of positions and extents, vectorized over the boxes of `a`.
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

// Likelihood of correspondence: geometric mean of the softmax over rows and the softmax over columns. Both sums run
// along rows, so that swapping the shapes gives the same bits.
Eigen::ArrayXXd mutual_softmax(const Eigen::MatrixXd& costs)
{
  const Eigen::ArrayXXd likelihood = (-costs.array()).exp(), transposed = likelihood.transpose();
  const Eigen::VectorXd of_rows = likelihood.rowwise().sum(), of_columns = transposed.rowwise().sum();
  return likelihood / (of_rows * of_columns.transpose()).array().sqrt();
}

// The pairs of parts by which boxes are warped towards those of the other shape, and the weights of these pairs.
struct Anchors
{
  std::array<std::vector<Eigen::Index>, 2> parts; // for either shape, the part of each pair
  std::vector<double> weights;
};

Anchors anchors_of(const Eigen::MatrixXd& costs, double least_likelihood)
{
  const Eigen::ArrayXXd likely = mutual_softmax(costs);
  const Steps least = quantized(least_likelihood);
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

// The boxes of one of the shapes (`side`), warped towards those of the other shape: along each axis, an end of a box
// moves by the mean of the displacements of the anchors' ends, weighted by closeness and the weight of the pair, and of
// a zero displacement with weight `inertia`.
Boxes warped(const Boxes& boxes, const Closeness& closeness, const Boxes& others, const Anchors& anchors,
             std::size_t side, double inertia)
{
  const std::vector<Eigen::Index>&own = anchors.parts[side], &other = anchors.parts[1 - side];
  const auto count = Eigen::Index(own.size());
  Eigen::ArrayXd displacement(2 * count), influence;
  Boxes result = boxes;
  for (int axis = 0; axis < 3; ++axis) {
    for (Eigen::Index k = 0; k < count; ++k) {
      const Eigen::Index i = own[std::size_t(k)], j = other[std::size_t(k)];
      displacement[2 * k] = others.low(j, axis) - boxes.low(i, axis);
      displacement[2 * k + 1] = others.high(j, axis) - boxes.high(i, axis);
    }
    for (Eigen::Index end = 0; end < 2 * boxes.low.rows(); ++end) {
      closeness.of_end(axis, end, own, influence);
      for (Eigen::Index k = 0; k < 2 * count; ++k)
        influence[k] *= anchors.weights[std::size_t(k / 2)];
      (end % 2 == 0 ? result.low : result.high)(end / 2, axis) +=
          (influence * displacement).sum() / (influence.sum() + inertia);
    }
  }
  return result;
}

// `costs_of_kind` plus the mean of three costs of boxes: as given, and after either shape was warped towards the other
// by the pairs that are most probable by all costs.
Eigen::MatrixXd costs_after_warping(const Shape_features& a, const Shape_features& b,
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

// Distances of the points of one shape's parts from the parts and unions of the other shape.
class Point_distances
{
public:
  Point_distances(const Shape_features& from, const Shape_features& to);

  // The distances of a part's points from a union of the other shape.
  Eigen::Map<const Eigen::ArrayXd> from_union(std::size_t part, std::size_t of_other) const
  {
    return {from_unions_.data() + begin_[part] + Eigen::Index(of_other) * count(part), count(part)};
  }
  double sum(std::size_t part, std::size_t other) const { return sums_(Eigen::Index(part), Eigen::Index(other)); }
  double mean(std::size_t part, std::size_t other) const { return sum(part, other) / double(count(part)); }
  Eigen::Index count(std::size_t part) const { return from_.surfaces[part].rows(); }

  // Room for the distances of a part's points from a part of the other shape, to be taken.
  double* room(std::size_t part, std::size_t other);
  void take(std::size_t part, std::size_t other);

private:
  const Shape_features& from_;
  std::vector<Eigen::Index> begin_;                 // for each part, the index of its first value in `from_unions_`
  std::vector<std::vector<std::size_t>> unions_of_; // for each part of the other shape, the unions that contain it
  Eigen::ArrayXd from_unions_, room_;
  Eigen::MatrixXd sums_; // sums of distances by part and other part
};

// The distances between the points of all parts of either shape and all parts of the other.
struct Surface_distances
{
  Point_distances a_from_b, b_from_a;

  Surface_distances(const Shape_features& a, const Shape_features& b, const Deadline& deadline);
};

Point_distances::Point_distances(const Shape_features& from, const Shape_features& to)
    : from_(from),
      unions_of_(to.surfaces.size()),
      sums_(Eigen::Index(from.surfaces.size()), Eigen::Index(to.surfaces.size()))
{
  for (std::size_t h = 0; h < to.unions.size(); ++h)
    for (std::size_t part : to.unions[h])
      unions_of_[part].push_back(h);
  Eigen::Index points = 0, most = 0;
  for (const Point_lanes& lanes : from.lanes) {
    begin_.push_back(points * Eigen::Index(to.unions.size()));
    points += lanes.count();
    most = std::max(most, lanes.padded());
  }
  from_unions_ =
      Eigen::ArrayXd::Constant(points * Eigen::Index(to.unions.size()), std::numeric_limits<double>::infinity());
  room_.resize(most + 1);
}

// The order in which Eigen adds numbers depends on whether the address of the first is even (in doubles); the parity is
// the one that an array of all distances would have.
double* Point_distances::room(std::size_t part, std::size_t other)
{
  return room_.data() + Eigen::Index(other) * count(part) % 2;
}

void Point_distances::take(std::size_t part, std::size_t other)
{
  const Eigen::Map<const Eigen::ArrayXd> distances(room(part, other), count(part));
  sums_(Eigen::Index(part), Eigen::Index(other)) = distances.sum();
  for (std::size_t of_other : unions_of_[other]) {
    Eigen::Map<Eigen::ArrayXd> nearest(from_unions_.data() + begin_[part] + Eigen::Index(of_other) * count(part),
                                       count(part));
    nearest = nearest.min(distances);
  }
}

Surface_distances::Surface_distances(const Shape_features& a, const Shape_features& b, const Deadline& deadline)
    : a_from_b(a, b), b_from_a(b, a)
{
  for (std::size_t i = 0; i < a.lanes.size(); ++i) {
    deadline.check();
    for (std::size_t j = 0; j < b.lanes.size(); ++j) {
      find_nearest(a.lanes[i], b.lanes[j], a_from_b.room(i, j), b_from_a.room(j, i));
      a_from_b.take(i, j);
      b_from_a.take(j, i);
    }
  }
}

// The chamfer distance of two parts: the mean distance of the points of either part from the other part.
double chamfer(const Point_distances& a_from_b, const Point_distances& b_from_a, std::size_t i, std::size_t j)
{
  return (a_from_b.mean(i, j) + b_from_a.mean(j, i)) / 2;
}

// The chamfer distance between a part and a union of parts. \param h index of the union
double chamfer(const Point_distances& a_from_b, const Point_distances& b_from_a, std::size_t i, std::size_t h,
               const std::vector<std::size_t>& parts)
{
  const Eigen::ArrayXd nearest = a_from_b.from_union(i, h);
  double sum = 0, n = 0;
  for (std::size_t j : parts) {
    sum += b_from_a.sum(j, i);
    n += double(b_from_a.count(j));
  }
  return (nearest.mean() + sum / n) / 2;
}

// Lowers the costs of pairs of parts to the costs between a part of `a` and a union that contains the part of `b`.
template <typename Costs>
void lower_to_unions(const Shape_features& a, const Shape_features& b, const Point_distances& a_from_b,
                     const Point_distances& b_from_a, const Part_matching_options& options, const Deadline& deadline,
                     Costs&& costs)
{
  if (b.unions.empty()) return;
  const Eigen::MatrixXd boxes = costs_of_boxes(a.boxes, b.union_boxes, options);
  const bool has_features = compares_features(a, b, options);
  for (std::size_t h = 0; h < b.unions.size(); ++h) {
    deadline.check();
    for (std::size_t i = 0; i < a.parts.size(); ++i) {
      const std::vector<std::size_t>& parts = b.unions[h];
      const double cost = cost_of_kind(a.parts[i], b.union_parts[h], options) +
                          boxes(Eigen::Index(i), Eigen::Index(h)) +
                          options.weights.chamfer * chamfer(a_from_b, b_from_a, i, h, parts) + options.whole +
                          (has_features ? cost_of_features(a.learned, i, b.learned_of_unions, h, options) : 0);
      for (std::size_t j : parts) {
        double& least = costs(Eigen::Index(i), Eigen::Index(j));
        least = std::min(least, cost);
      }
    }
  }
}

// The costs that warping does not change. \param surfaces null: surfaces are not compared
Eigen::MatrixXd costs_of_kind(const Shape_features& a, const Shape_features& b, const Surface_distances* surfaces,
                              const Part_matching_options& options)
{
  Eigen::MatrixXd result(Eigen::Index(a.parts.size()), Eigen::Index(b.parts.size()));
  const bool has_features = compares_features(a, b, options);
  for (std::size_t j = 0; j < b.parts.size(); ++j)
    for (std::size_t i = 0; i < a.parts.size(); ++i)
      result(Eigen::Index(i), Eigen::Index(j)) =
          cost_of_kind(a.parts[i], b.parts[j], options) +
          (surfaces ? options.weights.chamfer * chamfer(surfaces->a_from_b, surfaces->b_from_a, i, j) : 0) +
          (has_features ? cost_of_features(a.learned, i, b.learned, j, options) : 0);
  return result;
}

Eigen::MatrixXd ranked_part_costs(const Shape_features& a, const Shape_features& b,
                                  const Part_matching_options& options, const Deadline* deadline)
{
  if (!deadline) return costs_after_warping(a, b, costs_of_kind(a, b, nullptr, options), options);
  const Surface_distances surfaces(a, b, *deadline);
  Eigen::MatrixXd result = costs_after_warping(a, b, costs_of_kind(a, b, &surfaces, options), options);
  lower_to_unions(a, b, surfaces.a_from_b, surfaces.b_from_a, options, *deadline, result);
  lower_to_unions(b, a, surfaces.b_from_a, surfaces.a_from_b, options, *deadline, result.transpose());
  return result;
}

} // namespace

Eigen::MatrixXd evidence_of_features(const Shape_features& source, const Shape_features& target,
                                     const Part_matching_options& options)
{
  if (!compares_features(source, target, options)) return {};
  const Eigen::VectorXd of_source = source.learned.transpose() * target.mean_learned,
                        of_target = target.learned.transpose() * source.mean_learned;
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(of_source.size(), of_target.size());
  for (Eigen::Index j = 0; j < result.cols(); ++j)
    for (Eigen::Index i = 0; i < result.rows(); ++i)
      if (source.has_learned[std::size_t(i)] && target.has_learned[std::size_t(j)])
        result(i, j) = options.weights.features *
                       (source.learned.col(i).dot(target.learned.col(j)) - (of_source[i] + of_target[j]) / 2);
  return result;
}

double mean_least_cost(const Eigen::MatrixXd& costs)
{
  return costs.rowwise().minCoeff().mean() + costs.colwise().minCoeff().mean();
}

// The shapes are in canonical order, since the sums of the warp run over pairs source by source.
Eigen::MatrixXd part_costs(const Shape_features& source, const Shape_features& target,
                           const Part_matching_options& options, const Deadline* deadline)
{
  if (target.rank < source.rank) return ranked_part_costs(target, source, options, deadline).transpose();
  return ranked_part_costs(source, target, options, deadline);
}

} // namespace CGAL::Shape_correspondence

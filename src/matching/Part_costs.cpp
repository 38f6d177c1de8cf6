// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "matching/Part_costs.h"
#include "matching/Normalized_shape.h"
#include "matching/box_costs.h"
#include "matching/surface_distances.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL::Shape_correspondence {
using namespace internal;

namespace {

constexpr double union_charge = 1; // added where a part corresponds to a set of parts as a whole

// The least cost of every part of `a` and a union that every part of `b` is in; infinite for parts in none.
Eigen::MatrixXd costs_of_unions(const Normalized_shape& a, const Normalized_shape& b, const Point_distances& a_from_b,
                                const Point_distances& b_from_a, const Part_cost_weights& weights)
{
  Eigen::MatrixXd result = Eigen::MatrixXd::Constant(Eigen::Index(a.parts.size()), Eigen::Index(b.parts.size()),
                                                     std::numeric_limits<double>::infinity());
  const Eigen::MatrixXd boxes = costs_of_boxes(a.boxes, b.union_boxes, weights);
  for (std::size_t h = 0; h < b.unions.size(); ++h)
    for (std::size_t i = 0; i < a.parts.size(); ++i) {
      const std::vector<std::size_t>& parts = b.unions[h];
      const double cost = cost_of_kind(a.parts[i], b.union_parts[h], weights) +
                          boxes(Eigen::Index(i), Eigen::Index(h)) +
                          weights.chamfer * chamfer(a_from_b, b_from_a, i, parts) + union_charge;
      for (std::size_t j : parts) {
        double& least = result(Eigen::Index(i), Eigen::Index(j));
        least = std::min(least, cost);
      }
    }
  return result;
}

double mean_of_best(const Eigen::ArrayXXd& likelihood, const std::vector<std::size_t>& rows,
                    const std::vector<std::size_t>& columns)
{
  double sum = 0;
  for (std::size_t i : rows) {
    double best = 0;
    for (std::size_t j : columns)
      best = std::max(best, likelihood(Eigen::Index(i), Eigen::Index(j)));
    sum += best;
  }
  return sum / double(rows.size());
}

// How well the parts that two parts touch correspond: the mean over those of either of how likely their best
// counterpart among the other's is; geometric mean of the two.
Eigen::ArrayXXd contact_agreement(const Eigen::ArrayXXd& likelihood,
                                  const std::vector<std::vector<std::size_t>>& of_source,
                                  const std::vector<std::vector<std::size_t>>& of_target)
{
  const Eigen::ArrayXXd transposed = likelihood.transpose();
  Eigen::ArrayXXd result = Eigen::ArrayXXd::Zero(likelihood.rows(), likelihood.cols());
  for (std::size_t i = 0; i < of_source.size(); ++i)
    for (std::size_t j = 0; j < of_target.size(); ++j)
      if (!of_source[i].empty() && !of_target[j].empty())
        result(Eigen::Index(i), Eigen::Index(j)) = std::sqrt(mean_of_best(likelihood, of_source[i], of_target[j]) *
                                                             mean_of_best(transposed, of_target[j], of_source[i]));
  return result;
}

// The costs that no warp changes.
Eigen::MatrixXd costs_of_kind(const Normalized_shape& a, const Normalized_shape& b, const Point_distances& a_from_b,
                              const Point_distances& b_from_a, const Part_cost_weights& weights)
{
  Eigen::MatrixXd result(Eigen::Index(a.parts.size()), Eigen::Index(b.parts.size()));
  for (std::size_t i = 0; i < a.parts.size(); ++i)
    for (std::size_t j = 0; j < b.parts.size(); ++j)
      result(Eigen::Index(i), Eigen::Index(j)) =
          cost_of_kind(a.parts[i], b.parts[j], weights) + weights.chamfer * chamfer(a_from_b, b_from_a, i, j);
  return result;
}

Eigen::MatrixXd ranked_part_costs(const Normalized_shape& a, const Normalized_shape& b,
                                  const Part_cost_weights& weights)
{
  Point_distances a_from_b, b_from_a;
  point_distances(a, b, a_from_b, b_from_a);

  const Eigen::MatrixXd of_kind = costs_of_kind(a, b, a_from_b, b_from_a, weights);
  const Eigen::MatrixXd without_contacts =
      costs_after_warping(a.boxes, b.boxes, of_kind, weights)
          .cwiseMin(costs_of_unions(a, b, a_from_b, b_from_a, weights))
          .cwiseMin(costs_of_unions(b, a, b_from_a, a_from_b, weights).transpose());
  const Eigen::ArrayXXd agreement = contact_agreement(mutual_softmax(without_contacts), a.neighbours, b.neighbours);
  return without_contacts + weights.contacts * (1 - agreement).matrix();
}

} // namespace

double set_cost(const Eigen::MatrixXd& costs, const std::vector<std::size_t>& rows,
                const std::vector<std::size_t>& columns)
{
  double over_rows = 0, over_columns = 0;
  for (std::size_t i : rows) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t j : columns)
      least = std::min(least, costs(Eigen::Index(i), Eigen::Index(j)));
    over_rows += least;
  }
  for (std::size_t j : columns) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i : rows)
      least = std::min(least, costs(Eigen::Index(i), Eigen::Index(j)));
    over_columns += least;
  }
  return (over_rows / double(rows.size()) + over_columns / double(columns.size())) / 2;
}

double mean_least_cost(const Eigen::MatrixXd& costs)
{
  return costs.rowwise().minCoeff().mean() + costs.colwise().minCoeff().mean();
}

// In one order, whichever is the source: sums of the warp run over pairs source by source.
Eigen::MatrixXd part_costs(const Normalized_shape& source, const Normalized_shape& target,
                           const Part_cost_weights& weights)
{
  if (target.rank < source.rank) return ranked_part_costs(target, source, weights).transpose();
  return ranked_part_costs(source, target, weights);
}

Eigen::MatrixXd part_costs(const Aligned_shape& source, const Aligned_shape& target, const Part_cost_weights& weights)
{
  return part_costs(normalized_shape(source, part_assemblies(source)),
                    normalized_shape(target, part_assemblies(target)), weights);
}

Eigen::MatrixXd part_costs(const Normalized_shape& shape, const Part_cost_weights& weights)
{
  Eigen::MatrixXd result = costs_of_boxes(shape.boxes, shape.boxes, weights);
  for (std::size_t i = 0; i < shape.parts.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const auto row = Eigen::Index(i), column = Eigen::Index(j);
      result(row, column) += cost_of_kind(shape.parts[i], shape.parts[j], weights) +
                             weights.chamfer * chamfer(shape.lanes[i], shape.lanes[j]);
      result(column, row) = result(row, column);
    }
  return result;
}

Eigen::MatrixXd part_costs(const Aligned_shape& shape, const Part_cost_weights& weights)
{
  return part_costs(normalized_shape(shape, part_assemblies(shape)), weights);
}

} // namespace CGAL::Shape_correspondence

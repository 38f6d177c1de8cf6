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

// The least cost of every part of `a` and a union that every part of `b` is in; infinite for parts in none.
Eigen::MatrixXd costs_of_unions(const Normalized_shape& a, const Normalized_shape& b, const Point_distances& a_from_b,
                                const Point_distances& b_from_a, const Part_matching_options& options)
{
  Eigen::MatrixXd result = Eigen::MatrixXd::Constant(Eigen::Index(a.parts.size()), Eigen::Index(b.parts.size()),
                                                     std::numeric_limits<double>::infinity());
  const Eigen::MatrixXd boxes = costs_of_boxes(a.boxes, b.union_boxes, options);
  for (std::size_t h = 0; h < b.unions.size(); ++h)
    for (std::size_t i = 0; i < a.parts.size(); ++i) {
      const std::vector<std::size_t>& parts = b.unions[h];
      const double cost = cost_of_kind(a.parts[i], b.union_parts[h], options) +
                          boxes(Eigen::Index(i), Eigen::Index(h)) +
                          options.weights.chamfer * chamfer(a_from_b, b_from_a, i, parts) + options.whole;
      for (std::size_t j : parts) {
        double& least = result(Eigen::Index(i), Eigen::Index(j));
        least = std::min(least, cost);
      }
    }
  return result;
}

// The costs that no warp changes.
Eigen::MatrixXd costs_of_kind(const Normalized_shape& a, const Normalized_shape& b, const Point_distances& a_from_b,
                              const Point_distances& b_from_a, const Part_matching_options& options)
{
  Eigen::MatrixXd result(Eigen::Index(a.parts.size()), Eigen::Index(b.parts.size()));
  for (std::size_t i = 0; i < a.parts.size(); ++i)
    for (std::size_t j = 0; j < b.parts.size(); ++j)
      result(Eigen::Index(i), Eigen::Index(j)) =
          cost_of_kind(a.parts[i], b.parts[j], options) + options.weights.chamfer * chamfer(a_from_b, b_from_a, i, j);
  return result;
}

Eigen::MatrixXd ranked_part_costs(const Normalized_shape& a, const Normalized_shape& b,
                                  const Part_matching_options& options)
{
  Point_distances a_from_b, b_from_a;
  point_distances(a, b, a_from_b, b_from_a);

  const Eigen::MatrixXd of_kind = costs_of_kind(a, b, a_from_b, b_from_a, options);
  return costs_after_warping(a.boxes, b.boxes, of_kind, options)
      .cwiseMin(costs_of_unions(a, b, a_from_b, b_from_a, options))
      .cwiseMin(costs_of_unions(b, a, b_from_a, a_from_b, options).transpose());
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
                           const Part_matching_options& options)
{
  if (target.rank < source.rank) return ranked_part_costs(target, source, options).transpose();
  return ranked_part_costs(source, target, options);
}

Eigen::MatrixXd part_costs(const Aligned_shape& source, const Aligned_shape& target,
                           const Part_matching_options& options)
{
  return part_costs(normalized_shape(source, part_assemblies(source, options), options),
                    normalized_shape(target, part_assemblies(target, options), options), options);
}

Eigen::MatrixXd part_costs(const Normalized_shape& shape, const Part_matching_options& options)
{
  Eigen::MatrixXd result = costs_of_boxes(shape.boxes, shape.boxes, options);
  for (std::size_t i = 0; i < shape.parts.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const auto row = Eigen::Index(i), column = Eigen::Index(j);
      result(row, column) += cost_of_kind(shape.parts[i], shape.parts[j], options) +
                             options.weights.chamfer * chamfer(shape.lanes[i], shape.lanes[j]);
      result(column, row) = result(row, column);
    }
  return result;
}

Eigen::MatrixXd part_costs(const Aligned_shape& shape, const Part_matching_options& options)
{
  return part_costs(normalized_shape(shape, part_assemblies(shape, options), options), options);
}

} // namespace CGAL::Shape_correspondence

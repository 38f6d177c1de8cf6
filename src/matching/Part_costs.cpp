// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "matching/Part_costs.h"
#include "matching/Normalized_shape.h"
#include "matching/box_costs.h"
#include "matching/surface_distances.h"

#include <algorithm>
#include <vector>

namespace CGAL::Shape_correspondence {
using namespace internal;

namespace {

// Lowers the costs to those of parts of `a` and unions that the parts of `b` are in.
template <typename Costs>
void lower_to_unions(const Normalized_shape& a, const Normalized_shape& b, const Point_distances& a_from_b,
                     const Point_distances& b_from_a, const Part_matching_options& options, Costs&& costs)
{
  if (b.unions.empty()) return;
  const Eigen::MatrixXd boxes = costs_of_boxes(a.boxes, b.union_boxes, options);
  for (std::size_t h = 0; h < b.unions.size(); ++h)
    for (std::size_t i = 0; i < a.parts.size(); ++i) {
      const std::vector<std::size_t>& parts = b.unions[h];
      const double cost = cost_of_kind(a.parts[i], b.union_parts[h], options) +
                          boxes(Eigen::Index(i), Eigen::Index(h)) +
                          options.weights.chamfer * chamfer(a_from_b, b_from_a, i, parts) + options.whole;
      for (std::size_t j : parts) {
        double& least = costs(Eigen::Index(i), Eigen::Index(j));
        least = std::min(least, cost);
      }
    }
}

// The costs that no warp changes.
Eigen::MatrixXd costs_of_kind(const Normalized_shape& a, const Normalized_shape& b, const Surface_distances& surfaces,
                              const Part_matching_options& options)
{
  Eigen::MatrixXd result(Eigen::Index(a.parts.size()), Eigen::Index(b.parts.size()));
  for (std::size_t j = 0; j < b.parts.size(); ++j)
    for (std::size_t i = 0; i < a.parts.size(); ++i)
      result(Eigen::Index(i), Eigen::Index(j)) =
          cost_of_kind(a.parts[i], b.parts[j], options) +
          options.weights.chamfer * chamfer(surfaces.a_from_b, surfaces.b_from_a, i, j);
  return result;
}

Eigen::MatrixXd ranked_part_costs(const Normalized_shape& a, const Normalized_shape& b,
                                  const Part_matching_options& options)
{
  const Surface_distances surfaces(a, b);
  Eigen::MatrixXd result = costs_after_warping(a, b, costs_of_kind(a, b, surfaces, options), options);
  lower_to_unions(a, b, surfaces.a_from_b, surfaces.b_from_a, options, result);
  lower_to_unions(b, a, surfaces.b_from_a, surfaces.a_from_b, options, result.transpose());
  return result;
}

} // namespace

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

} // namespace CGAL::Shape_correspondence

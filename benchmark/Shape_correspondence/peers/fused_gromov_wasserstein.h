// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "unit_box.h"

namespace CGAL::Shape_correspondence::peers {

/// For each pair of parts, the number of contacts on the shortest path between them; for unconnected parts, one more
/// than the greatest of these numbers. Scaled to [0, 1].
inline Eigen::MatrixXd contact_distances(const Boxed_shape& shape)
{
  const auto n = Eigen::Index(shape.neighbours.size());
  Eigen::MatrixXd result = Eigen::MatrixXd::Constant(n, n, -1);
  double most = 0;
  for (Eigen::Index i = 0; i < n; ++i) {
    std::vector<std::size_t> queue{std::size_t(i)};
    result(i, i) = 0;
    for (std::size_t k = 0; k < queue.size(); ++k)
      for (std::size_t j : shape.neighbours[queue[k]])
        if (result(i, Eigen::Index(j)) < 0) {
          result(i, Eigen::Index(j)) = result(i, Eigen::Index(queue[k])) + 1;
          queue.push_back(j);
        }
    most = std::max(most, result.row(i).maxCoeff());
  }
  return (result.array() < 0).select(most + 1, result.array()).matrix() / (most + 1);
}

/// Scales a positive matrix until all rows have the same sum, and all columns; the sum of all entries is 1.
inline Eigen::MatrixXd sinkhorn(Eigen::MatrixXd plan)
{
  constexpr int steps = 60;
  const double row_sum = 1. / double(plan.rows()), column_sum = 1. / double(plan.cols());
  for (int i = 0; i < steps; ++i) {
    plan = (row_sum * plan.rowwise().sum().array().inverse()).matrix().asDiagonal() * plan;
    plan = plan * (column_sum * plan.colwise().sum().array().inverse()).matrix().asDiagonal();
  }
  return plan;
}

/// T. Vayer et al., *Optimal transport for structured data*, 2019: the coupling of parts that is cheap by squared
/// Hausdorff distance in unit boxes and keeps distances along contacts, by the proximal point method (H. Xu et al.,
/// *Gromov-Wasserstein learning*, 2019). Strong entries are the correspondence.
inline Part_pairs match_by_fused_gromov_wasserstein(const Boxed_shape& source, const Boxed_shape& target)
{
  constexpr double structure_share = 0.5, step = 0.03, least_share = 0.5;
  constexpr int iterations = 50;
  const Eigen::MatrixXd features = part_distances(source, target, hausdorff).cwiseAbs2();
  const Eigen::MatrixXd a = contact_distances(source), b = contact_distances(target);
  const auto n = features.rows(), m = features.cols();
  const Eigen::VectorXd squares_a = a.array().square().rowwise().mean(),
                        squares_b = b.array().square().rowwise().mean();
  Eigen::MatrixXd plan = Eigen::MatrixXd::Constant(n, m, 1. / double(n * m));
  for (int i = 0; i < iterations; ++i) {
    Eigen::MatrixXd gradient = -2 * a * plan * b.transpose();
    gradient.colwise() += squares_a;
    gradient.rowwise() += squares_b.transpose();
    const Eigen::ArrayXXd cost = (1 - structure_share) * features.array() + 2 * structure_share * gradient.array();
    plan = sinkhorn((plan.array() * (-(cost - cost.minCoeff()) / step).exp()).max(1e-200).matrix());
  }
  return strong_entries(plan, least_share);
}

} // namespace CGAL::Shape_correspondence::peers

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "roles/pair_model.h"
#include "base/quantized.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace CGAL::Shape_correspondence::internal {

Pair_weights usual_pair_weights()
{
  Pair_weights result;
  result << 3.122, -3.578, 7.431, 0.497, -0.059, -5.240;
  return result;
}

Pair_weights usual_pair_weights(std::size_t labelled_shapes)
{
  // Difference from the usual weights, times the square root of the number of shapes: the mean of those that
  // `validate_roles --leave-out category --told --number-of-examples N` fits for N = 1, 3, 5
  Pair_weights of_few;
  of_few << -2.60, 2.89, -3.45, 0.79, -0.12, 1.46;
  return usual_pair_weights() + of_few / std::sqrt(double(labelled_shapes));
}

Eigen::MatrixXd excess_of_pairs(const Eigen::MatrixXd& costs)
{
  const Eigen::VectorXd of_source = costs.rowwise().minCoeff(), of_target = costs.colwise().minCoeff();
  Eigen::MatrixXd result(costs.rows(), costs.cols());
  for (Eigen::Index j = 0; j < costs.cols(); ++j)
    for (Eigen::Index i = 0; i < costs.rows(); ++i)
      result(i, j) = (costs(i, j) - of_source[i]) + (costs(i, j) - of_target[j]); // exactly symmetric
  return result;
}

Eigen::ArrayXd probabilities(const Pair_terms& terms, const Pair_weights& weights, const Eigen::ArrayXd& evidence)
{
  Eigen::ArrayXd logits = (terms * weights).array();
  if (evidence.size() > 0) logits += evidence;
  return 1 / (1 + (-logits).exp());
}

std::vector<char> pairs_of_greatest_expected_f1(const Eigen::ArrayXd& probabilities)
{
  std::vector<Steps> steps;
  for (double p : probabilities)
    steps.push_back(quantized(p));
  std::vector<Steps> descending = steps;
  std::sort(descending.begin(), descending.end(), std::greater<>());
  double expected = 0; // expected number of right pairs, in steps
  for (Steps step : descending)
    expected += double(step);
  const double step_count = 1 / comparison_grid;
  double right = 0, best = 0;
  Steps least = descending.empty() ? 0 : descending.front();
  for (std::size_t k = 0; k < descending.size(); ++k) {
    right += double(descending[k]);
    const bool is_last_of_equals = k + 1 == descending.size() || descending[k + 1] < descending[k];
    const double f1 = 2 * right / (double(k + 1) * step_count + expected);
    if (!is_last_of_equals || f1 <= best) continue;
    best = f1;
    least = descending[k];
  }
  std::vector<char> result;
  for (Steps step : steps)
    result.push_back(step >= least);
  return result;
}

Eigen::Matrix<double, 1, CONFIDENCE_TERM_COUNT> confidence_terms(double probability)
{
  const double p = std::clamp(probability, least_doubt, 1 - least_doubt);
  return {std::log(p / (1 - p)), 1};
}

double confidence(double probability, const Confidence_weights& weights)
{
  if (probability <= 0 || probability >= 1) return probability;
  return 1 / (1 + std::exp(-confidence_terms(probability).dot(weights)));
}

} // namespace CGAL::Shape_correspondence::internal

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "matching/aligned_matching.h"
#include "base/quantized.h"
#include "matching/Part_costs.h"

#include <algorithm>
#include <cmath>

namespace CGAL::Shape_correspondence::internal {

namespace {

// Logarithm of the shape's width over its depth; 0 if one of them vanishes.
double log_proportion(const Aligned_shape& shape)
{
  Point low = shape.parts[0].surface.col(0), high = low;
  for (const Sampled_part& part : shape.parts) {
    low = low.cwiseMin(part.surface.rowwise().minCoeff());
    high = high.cwiseMax(part.surface.rowwise().maxCoeff());
  }
  const Point extent = high - low;
  return std::min(extent.x(), extent.z()) > comparison_grid ? std::log(extent.x() / extent.z()) : 0;
}

// The pairs of the geometric match whose two parts are in no other pair, of cost at most `largest_cost`.
Part_pairs same_parts(const Part_matching& geometric, double largest_cost)
{
  std::vector<int> of_source(std::size_t(geometric.costs.rows())), of_target(std::size_t(geometric.costs.cols()));
  for (const Part_correspondence& pair : geometric.pairs) {
    ++of_source[pair.source];
    ++of_target[pair.target];
  }
  Part_pairs result;
  for (const Part_correspondence& pair : geometric.pairs)
    if (of_source[pair.source] == 1 && of_target[pair.target] == 1 &&
        quantized(geometric.costs(Eigen::Index(pair.source), Eigen::Index(pair.target))) <= quantized(largest_cost))
      result.emplace_back(pair.source, pair.target);
  return result;
}

} // namespace

std::vector<std::vector<Group_label>> group_labels(const Part_matching& matching, const Aligned_shape& source,
                                                   const Aligned_shape& target)
{
  std::vector<std::vector<std::size_t>> images(source.parts.size());
  for (const Part_correspondence& pair : matching.pairs)
    images[pair.source].push_back(pair.target);

  std::vector<std::vector<Group_label>> labels;
  for (const Part_group& group : groups(source)) {
    Group_label label;
    for (std::size_t part : group.parts) {
      label.images.emplace_back().reserve(images[part].size());
      for (std::size_t image : images[part])
        label.images.back().push_back({{part}, {image}});
    }
    const std::vector<std::size_t> parts = image_parts(label);
    if (!parts.empty()) {
      label.target_group = target.group_of[parts[0]];
      label.operation = topological_operation(group.parts.size(), parts.size());
      if (target.group(label.target_group).parts == parts)
        label.solidity_ratio = solidity_ratio(group, target.group(label.target_group));
    }
    labels.emplace_back().push_back(std::move(label));
  }
  return labels;
}

Steps alignment_cost(const Part_matching& matching, const Aligned_shape& source, const Aligned_shape& target)
{
  return quantized(mean_least_cost(matching.costs) + std::abs(log_proportion(source) - log_proportion(target)));
}

std::vector<Part_correspondence> original_pairs(const Part_matching& matching, const Aligned_shape& source,
                                                const Aligned_shape& target)
{
  std::vector<Part_correspondence> result = matching.pairs;
  for (Part_correspondence& pair : result) {
    pair.source = source.original[pair.source];
    pair.target = target.original[pair.target];
  }
  std::sort(result.begin(), result.end(), is_before);
  return result;
}

Part_correspondence likeliest_source(const Part_matching& matching, std::size_t target)
{
  const auto column = Eigen::Index(target);
  Eigen::Index best = 0;
  if (matching.probabilities.size() > 0) {
    const double probability = matching.probabilities.col(column).maxCoeff(&best);
    return {std::size_t(best), target, probability};
  }
  matching.costs.col(column).minCoeff(&best);
  Part_correspondence result{std::size_t(best), target, 0};
  for (const Part_correspondence& pair : matching.pairs)
    if (pair.target == target && pair.confidence > result.confidence) result = pair;
  return result;
}

Part_matching renumbered(const Part_matching& matching, const std::vector<std::size_t>& rows,
                         const std::vector<std::size_t>& columns)
{
  Part_matching result = matching;
  for (Part_correspondence& pair : result.pairs) {
    pair.source = rows[pair.source];
    pair.target = columns[pair.target];
  }
  for (auto values : {&Part_matching::costs, &Part_matching::evidence})
    for (std::size_t i = 0; (matching.*values).size() > 0 && i < rows.size(); ++i)
      for (std::size_t j = 0; j < columns.size(); ++j)
        (result.*values)(Eigen::Index(rows[i]), Eigen::Index(columns[j])) =
            (matching.*values)(Eigen::Index(i), Eigen::Index(j));
  return result;
}

Part_matching match_by_terms(const Pair_terms& terms, const Pair_weights& weights, Part_matching geometric,
                             const Match_constraints& constraints, const Part_matching_options& options)
{
  const auto m = std::size_t(geometric.costs.cols());
  Eigen::ArrayXd probable = probabilities(terms, weights, geometric.evidence.transpose().reshaped().array());
  for (const auto& [i, j] : same_parts(geometric, options.tolerance))
    for (std::size_t k = 0; k < std::size_t(probable.size()); ++k)
      if ((k / m == i) != (k % m == j)) probable[Eigen::Index(k)] = 0;
  for (std::size_t k = 0; !constraints.empty() && k < std::size_t(probable.size()); ++k) {
    if (constraints.pinned(k / m).count(k % m) > 0) probable[Eigen::Index(k)] = 1;
    if (!constraints.allows(k / m, k % m)) probable[Eigen::Index(k)] = 0;
  }
  const std::vector<char> taken = pairs_of_greatest_expected_f1(probable);
  geometric.pairs.clear();
  geometric.probabilities.resize(geometric.costs.rows(), geometric.costs.cols());
  for (std::size_t k = 0; k < taken.size(); ++k) {
    const double probability = probable[Eigen::Index(k)];
    geometric.probabilities(Eigen::Index(k / m), Eigen::Index(k % m)) = probability;
    if (taken[k]) geometric.pairs.push_back({k / m, k % m, probability});
  }
  return geometric;
}

void state_confidences(const Confidence_weights& weights, Part_matching& matching)
{
  if (weights == usual_confidence_weights()) return; // leaves the confidences bitwise unchanged
  for (Part_correspondence& pair : matching.pairs)
    pair.confidence = confidence(pair.confidence, weights);
  matching.probabilities = matching.probabilities.unaryExpr([&](double p) { return confidence(p, weights); }).eval();
}

} // namespace CGAL::Shape_correspondence::internal

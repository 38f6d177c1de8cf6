// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "matching/match_by_roles.h"
#include "base/quantized.h"

#include <algorithm>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

namespace {

// Pairs of the geometric match that either part has alone, at a cost of no more than `largest_cost`.
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

Part_matching match_by_terms(const Pair_terms& terms, const Pair_weights& weights, Part_matching geometric,
                             const Match_constraints& constraints, const Part_matching_options& options)
{
  const auto m = std::size_t(geometric.costs.cols());
  Eigen::ArrayXd probable = probabilities(terms, weights);
  for (const auto& [i, j] : same_parts(geometric, options.tolerance))
    for (std::size_t k = 0; k < std::size_t(probable.size()); ++k)
      if ((k / m == i) != (k % m == j)) probable[Eigen::Index(k)] = 0;
  for (std::size_t k = 0; !constraints.empty() && k < std::size_t(probable.size()); ++k) {
    const std::vector<std::size_t>& pinned = constraints.pinned(k / m);
    if (std::binary_search(pinned.begin(), pinned.end(), k % m)) probable[Eigen::Index(k)] = 1;
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
  if (weights == usual_confidence_weights()) return; // to the last bit
  for (Part_correspondence& pair : matching.pairs)
    pair.confidence = confidence(pair.confidence, weights);
  matching.probabilities = matching.probabilities.unaryExpr([&](double p) { return confidence(p, weights); }).eval();
}

} // namespace CGAL::Shape_correspondence::internal

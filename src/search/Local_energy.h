// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Pairwise_energy.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

// Changes of the energy when one variable changes its label, computed from the terms of the variable alone.
class Local_energy
{
public:
  explicit Local_energy(const Pairwise_energy& energy) : energy_(energy), edges_of_(energy.number_of_variables())
  {
    for (std::size_t e = 0; e < energy.edges.size(); ++e)
      for (std::size_t v : {energy.edges[e].first, energy.edges[e].second})
        edges_of_[v].push_back(e);
  }

  // The change of the energy for each new label of v.
  std::vector<double> rises(std::size_t v, const Assignment& assignment) const
  {
    const auto edge_cost = [&](std::size_t e) -> const Eigen::MatrixXd& { return energy_.edges[e].cost; };
    const std::size_t present = std::size_t(assignment[v]);
    std::vector<double> result = sums(v, assignment, energy_.unary, edge_cost, true);
    std::transform(result.begin(), result.end(), result.begin(), [now = result[present]](double x) { return x - now; });
    for (const Pairwise_energy::Root_term& term : energy_.root_terms) {
      const auto share = [&](std::size_t e) -> const Eigen::MatrixXd& { return term.edge[e]; };
      const std::vector<double> shares = sums(v, assignment, term.unary, share, !term.edge.empty());
      const double total = energy_.root_sum(term, assignment), root = std::sqrt(total / term.count);
      for (std::size_t l = 0; l < result.size(); ++l)
        result[l] += term.weight * (root - std::sqrt(std::max(0., total + shares[l] - shares[present]) / term.count));
    }
    return result;
  }

private:
  // For each label of v, the sum of the terms that depend on it. \param unary, of_edge tables of these terms
  template <typename Of_edge>
  std::vector<double> sums(std::size_t v, const Assignment& assignment, const std::vector<Eigen::VectorXd>& unary,
                           const Of_edge& of_edge, bool has_edges) const
  {
    std::vector<double> result(unary[v].begin(), unary[v].end());
    if (!has_edges) return result;
    for (std::size_t e : edges_of_[v]) {
      const bool is_first = energy_.edges[e].first == v;
      const int other = assignment[is_first ? energy_.edges[e].second : energy_.edges[e].first];
      for (std::size_t l = 0; l < result.size(); ++l)
        result[l] += is_first ? of_edge(e)(Eigen::Index(l), other) : of_edge(e)(other, Eigen::Index(l));
    }
    return result;
  }

  const Pairwise_energy& energy_;
  std::vector<std::vector<std::size_t>> edges_of_;
};

} // namespace CGAL::Shape_correspondence::internal

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "search/Tangents.h"
#include "search/min_fill_order.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL::Shape_correspondence::internal {

Tangents::Tangents(const Pairwise_energy& energy, const std::vector<std::size_t>& order, std::size_t table_limit,
                   const Deadline& deadline)
    : energy_(energy), order_(order), deadline_(deadline), unary_(order.size())
{
  std::vector<std::size_t> position(order.size()), labels;
  std::vector<std::vector<std::size_t>> scopes;
  for (std::size_t i = 0; i < order.size(); ++i) {
    position[order[i]] = i;
    labels.push_back(energy.number_of_labels(order[i]));
    scopes.push_back({i});
  }
  for (const Pairwise_energy::Edge& edge : energy.edges) {
    const std::size_t a = position[edge.first], b = position[edge.second];
    is_turned_.push_back(a > b);
    pairs_.push_back({std::min(a, b), std::max(a, b), {}});
    scopes.push_back({std::min(a, b), std::max(a, b)});
  }
  buckets_ = std::make_unique<Mini_buckets>(std::move(labels), table_limit, std::move(scopes), deadline);
}

void Tangents::touch(const std::vector<double>& touched, Tangent_bound& bound)
{
  for (std::size_t i = 0; i < order_.size(); ++i)
    unary_[i] = energy_.unary[order_[i]];
  for (std::size_t e = 0; e < pairs_.size(); ++e)
    set_cost(e, energy_.edges[e].cost);
  // Tangent at Q = q: w (1 - sqrt(Q / n)) >= w (1 - sqrt(q / n) / 2) - slope Q
  bound.offset = 0;
  for (std::size_t r = 0; r < touched.size(); ++r) {
    const Pairwise_energy::Root_term& term = energy_.root_terms[r];
    bound.offset += term.weight * (1 - std::sqrt(touched[r] / term.count) / 2);
    const double slope = term.weight / (2 * std::sqrt(term.count * touched[r]));
    for (std::size_t i = 0; i < order_.size(); ++i)
      unary_[i] -= slope * term.unary[order_[i]];
    for (std::size_t e = 0; e < term.edge.size(); ++e)
      if (is_turned_[e])
        pairs_[e].cost -= slope * term.edge[e].transpose();
      else
        pairs_[e].cost -= slope * term.edge[e];
  }
  constexpr int first_sweeps = 8, next_sweeps = 4;
  if (!exact()) pass_messages_(unary_, pairs_, pass_messages_.has_messages() ? next_sweeps : first_sweeps, deadline_);

  for (std::size_t i = 0; i < unary_.size(); ++i)
    std::copy(unary_[i].begin(), unary_[i].end(), bound.tables.values(i));
  for (std::size_t e = 0; e < pairs_.size(); ++e) {
    const Eigen::MatrixXd& cost = pairs_[e].cost;
    Eigen::Map<Eigen::MatrixXd>(bound.tables.values(unary_.size() + e), cost.cols(), cost.rows()) = cost.transpose();
  }
  bound.tables.run(deadline_);
}

void Tangents::set_cost(std::size_t pair, const Eigen::MatrixXd& cost)
{
  if (is_turned_[pair])
    pairs_[pair].cost = cost.transpose();
  else
    pairs_[pair].cost = cost;
}

std::vector<std::size_t> elimination_order(const Pairwise_energy& energy, const Deadline& deadline)
{
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  for (const Pairwise_energy::Edge& edge : energy.edges)
    edges.emplace_back(edge.first, edge.second);
  return min_fill_order(energy.number_of_variables(), edges, deadline);
}

} // namespace CGAL::Shape_correspondence::internal

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "search/Tangents.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL::Shape_correspondence::internal {

std::vector<std::size_t> min_fill_order(std::size_t n, const std::vector<std::pair<std::size_t, std::size_t>>& edges,
                                        const Deadline& deadline)
{
  std::vector<char> adjacent(n * n, 0);
  std::vector<std::vector<std::size_t>> neighbours(n); // among vertices that are not yet eliminated
  const auto connect = [&](std::size_t a, std::size_t b) {
    if (a == b || adjacent[a * n + b]) return;
    adjacent[a * n + b] = adjacent[b * n + a] = 1;
    neighbours[a].push_back(b);
    neighbours[b].push_back(a);
  };
  for (const auto& edge : edges)
    connect(edge.first, edge.second);
  const auto fill_of = [&](std::size_t v) {
    deadline.check();
    std::size_t fill = 0;
    for (std::size_t i = 0; i < neighbours[v].size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        fill += !adjacent[neighbours[v][i] * n + neighbours[v][j]];
    return fill;
  };

  std::vector<std::size_t> fill(n), order;
  for (std::size_t v = 0; v < n; ++v)
    fill[v] = fill_of(v);
  std::vector<char> eliminated(n, 0), touched(n, 0);
  for (std::size_t step = 0; step < n; ++step) {
    std::size_t best = n;
    for (std::size_t v = 0; v < n; ++v)
      if (!eliminated[v] && (best == n || fill[v] < fill[best])) best = v;
    eliminated[best] = 1;
    order.push_back(best);
    const std::vector<std::size_t> around = neighbours[best];
    for (std::size_t a : around)
      neighbours[a].erase(std::find(neighbours[a].begin(), neighbours[a].end(), best));
    for (std::size_t a : around)
      for (std::size_t b : around)
        connect(a, b);
    // The fill of a vertex depends on the edges among its neighbours, which changed
    std::fill(touched.begin(), touched.end(), 0);
    for (std::size_t a : around) {
      touched[a] = 1;
      for (std::size_t b : neighbours[a])
        touched[b] = 1;
    }
    for (std::size_t v = 0; v < n; ++v)
      if (touched[v]) fill[v] = fill_of(v);
  }
  std::reverse(order.begin(), order.end());
  return order;
}

void Message_passing::operator()(std::vector<Eigen::VectorXd>& unary, std::vector<Pair_cost>& pairs, int sweeps,
                                 const Deadline& deadline)
{
  if (!has_messages()) start(unary, pairs);
  for (std::size_t e = 0; e < pairs.size(); ++e)
    transposed_[e] = pairs[e].cost.transpose();
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (std::size_t v = 0; v < unary.size(); ++v)
      deadline.check(), pass(unary[v], pairs, v, true);
    for (std::size_t v = unary.size(); v-- > 0;)
      deadline.check(), pass(unary[v], pairs, v, false);
  }
  for (std::size_t e = 0; e < pairs.size(); ++e) {
    unary[pairs[e].first] += to_first_[e];
    unary[pairs[e].second] += to_second_[e];
    pairs[e].cost.colwise() -= to_first_[e];
    pairs[e].cost.rowwise() -= to_second_[e].transpose();
  }
}

void Message_passing::start(const std::vector<Eigen::VectorXd>& unary, const std::vector<Pair_cost>& pairs)
{
  pairs_of_.resize(unary.size());
  transposed_.resize(pairs.size());
  for (std::size_t e = 0; e < pairs.size(); ++e) {
    pairs_of_[pairs[e].first].forward.push_back(e);
    pairs_of_[pairs[e].second].backward.push_back(e);
    to_first_.push_back(Eigen::VectorXd::Zero(pairs[e].cost.rows()));
    to_second_.push_back(Eigen::VectorXd::Zero(pairs[e].cost.cols()));
  }
}

void Message_passing::pass(const Eigen::VectorXd& unary, const std::vector<Pair_cost>& pairs, std::size_t v,
                           bool is_forward)
{
  const Pairs_of& around = pairs_of_[v];
  sum_ = unary;
  for (std::size_t e : around.forward)
    sum_ += to_first_[e];
  for (std::size_t e : around.backward)
    sum_ += to_second_[e];
  sum_ /= double(std::max<std::size_t>(1, std::max(around.forward.size(), around.backward.size())));
  for (std::size_t e : is_forward ? around.forward : around.backward) {
    const Eigen::MatrixXd& cost = is_forward ? transposed_[e] : pairs[e].cost; // one column for each label of v
    Eigen::VectorXd& message = is_forward ? to_second_[e] : to_first_[e];
    moved_ = sum_ - (is_forward ? to_first_[e] : to_second_[e]);
    message = cost.col(0).array() + moved_[0];
    for (Eigen::Index l = 1; l < cost.cols(); ++l)
      message = message.array().min(cost.col(l).array() + moved_[l]);
    message.array() -= message.minCoeff();
  }
}

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
  constexpr int first_sweeps = 8, next_sweeps = 4; // passes of messages: fewer when they start from the last ones
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

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/Disjoint_sets.h"
#include "base/for_each_index.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/markov_clustering.h>

#include <CGAL/assertions.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace CGAL::Shape_correspondence {

namespace {

using Flow_matrix = Eigen::SparseMatrix<double>; // column-stochastic

void check(const Eigen::SparseMatrix<double>& weights, const Markov_clustering_options& options)
{
  if (!(options.inflation > 1) || !(options.expansion_limit >= 0 && options.expansion_limit < 1) ||
      options.column_limit == 0 || options.entry_limit == 0 || !(options.tolerance > 0))
    throw Invalid_input("markov_clustering: the inflation must be more than 1, the limits within their ranges");
  for (Eigen::Index j = 0; j < weights.outerSize(); ++j)
    for (Flow_matrix::InnerIterator entry(weights, j); entry; ++entry)
      if (!(entry.value() >= 0) || std::isinf(entry.value()))
        throw Invalid_input("markov_clustering: a weight is negative or not finite; give finite ones of at least 0");
}

using Column = std::vector<std::pair<Eigen::Index, double>>;

double sum_of(const Column& column)
{
  double sum = 0;
  for (const auto& entry : column)
    sum += entry.second;
  return sum;
}

/// Appends the next column to a flow, scaled to sum 1.
void append_column(Column column, Flow_matrix& flow, Eigen::Index j)
{
  const double sum = sum_of(column);
  std::sort(column.begin(), column.end());
  flow.startVec(j);
  for (const auto& [i, value] : column)
    flow.insertBack(i, j) = value / sum;
}

Flow_matrix first_flow(const Eigen::SparseMatrix<double>& weights)
{
  Flow_matrix flow(weights.cols(), weights.cols());
  for (Eigen::Index j = 0; j < weights.outerSize(); ++j) {
    Column column;
    double most = 0;
    for (Flow_matrix::InnerIterator entry(weights, j); entry; ++entry) {
      if (entry.row() == j || entry.value() == 0) continue;
      column.emplace_back(entry.row(), entry.value());
      most = std::max(most, entry.value());
    }
    column.emplace_back(j, most > 0 ? most : 1);
    append_column(std::move(column), flow, j);
  }
  flow.finalize();
  return flow;
}

std::size_t column_limit(const Markov_clustering_options& options, Eigen::Index columns)
{
  const auto all = std::max<std::size_t>(1, std::size_t(columns));
  return std::min({std::max<std::size_t>(1, options.entry_limit / all), options.column_limit, all});
}

// Keeps only the largest entries of a column (ties by index) above a threshold.
void prune(const Markov_clustering_options& options, std::size_t column_limit, Column& column)
{
  double most = 0;
  for (const auto& entry : column)
    most = std::max(most, entry.second);
  const double limit = std::min(options.expansion_limit, most);
  column.erase(std::remove_if(column.begin(), column.end(), [&](const auto& entry) { return entry.second < limit; }),
               column.end());
  if (column.size() <= column_limit) return;
  std::stable_sort(column.begin(), column.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
  column.resize(column_limit);
  std::sort(column.begin(), column.end());
}

struct Flow_columns
{
  std::vector<Column> columns; ///< not normalized
  double chaos = 0;
};

/// Some columns of the squared flow, pruned and inflated.
Flow_columns inflated_columns(const Markov_clustering_options& options, std::size_t limit, const Flow_matrix& flow,
                              Eigen::Index first, Eigen::Index number)
{
  const Flow_matrix squared = flow * flow.middleCols(first, number);
  Flow_columns result;
  for (Eigen::Index j = 0; j < squared.cols(); ++j) {
    Column column;
    for (Flow_matrix::InnerIterator entry(squared, j); entry; ++entry)
      column.emplace_back(entry.row(), entry.value());
    prune(options, limit, column);
    const double sum = sum_of(column);
    double most = 0, squares = 0;
    for (auto& entry : column) {
      const double share = entry.second / sum;
      most = std::max(most, share);
      squares += share * share;
      entry.second = std::pow(share, options.inflation);
    }
    result.chaos = std::max(result.chaos, most - squares);
    result.columns.push_back(std::move(column));
  }
  return result;
}

/// Expands (squares), prunes and inflates a flow; by blocks of columns, since unpruned columns have many entries.
/// \return the largest deviation of a column from one whose nonzero entries are equal, from 0 to 1
double step(const Markov_clustering_options& options, Flow_matrix& flow)
{
  constexpr Eigen::Index columns_at_a_time = 64, blocks_at_a_time = 16;
  const std::size_t limit = column_limit(options, flow.cols());
  Flow_matrix result(flow.rows(), flow.cols());
  result.reserve(Eigen::Index(limit) * flow.cols()); // avoids repeated growth
  double chaos = 0;
  for (Eigen::Index done = 0; done < flow.cols(); done += blocks_at_a_time * columns_at_a_time) {
    std::vector<Flow_columns> blocks(blocks_at_a_time);
    internal::for_each_index<CGAL::Parallel_if_available_tag>(blocks.size(), [&](std::size_t b) {
      const Eigen::Index first = done + Eigen::Index(b) * columns_at_a_time;
      if (first >= flow.cols()) return;
      blocks[b] = inflated_columns(options, limit, flow, first, std::min(columns_at_a_time, flow.cols() - first));
    });
    Eigen::Index j = done;
    for (Flow_columns& block : blocks) {
      chaos = std::max(chaos, block.chaos);
      for (Column& column : block.columns)
        append_column(std::move(column), result, j++);
    }
  }
  result.finalize();
  flow.swap(result);
  return chaos;
}

// Attractors that share flow form one system; a node belongs to the system that gets most of its flow.
std::vector<std::size_t> systems_of(const Flow_matrix& flow)
{
  const auto n = std::size_t(flow.cols());
  internal::Disjoint_sets systems(n);
  constexpr double least_share = 1e-2; // share of flow below which it is about to vanish
  std::vector<std::size_t> attractor(n);
  for (std::size_t j = 0; j < n; ++j) {
    double most = 0;
    for (Flow_matrix::InnerIterator entry(flow, Eigen::Index(j)); entry; ++entry)
      if (entry.value() > most) most = entry.value(), attractor[j] = std::size_t(entry.row());
  }
  std::vector<char> is_attractor(n, 0);
  for (std::size_t j = 0; j < n; ++j)
    is_attractor[attractor[j]] = 1;
  for (std::size_t j = 0; j < n; ++j) {
    if (!is_attractor[j]) continue;
    for (Flow_matrix::InnerIterator entry(flow, Eigen::Index(j)); entry; ++entry)
      if (entry.value() >= least_share) systems.unite(j, std::size_t(entry.row()));
  }
  std::vector<std::size_t> result(n);
  for (std::size_t j = 0; j < n; ++j)
    result[j] = systems[attractor[j]];
  return result;
}

} // namespace

Markov_clustering markov_clustering(const Eigen::SparseMatrix<double>& weights,
                                    const Markov_clustering_options& options)
{
  CGAL_precondition(weights.rows() == weights.cols());
  check(weights, options);
  Flow_matrix flow = first_flow(weights);
  Markov_clustering result;
  while (!result.converged && result.iterations < options.maximum_iterations) {
    result.converged = step(options, flow) < options.tolerance;
    ++result.iterations;
  }
  std::map<std::size_t, std::size_t> label_of;
  for (std::size_t system : systems_of(flow))
    result.labels.push_back(label_of.emplace(system, label_of.size()).first->second);
  result.number_of_clusters = label_of.size();
  return result;
}

} // namespace CGAL::Shape_correspondence

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/Disjoint_sets.h"
#include "base/for_each_index.h"
#include "base/target_clones.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/markov_clustering.h>

#include <CGAL/assertions.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
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

/// Appends column j, whose entries are sorted by row, to a flow, scaled to sum 1.
void append_column(const Column& column, Flow_matrix& flow, Eigen::Index j)
{
  const double sum = sum_of(column);
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
    std::sort(column.begin(), column.end());
    append_column(column, flow, j);
  }
  flow.finalize();
  return flow;
}

std::size_t column_limit(const Markov_clustering_options& options, Eigen::Index columns)
{
  const auto all = std::max<std::size_t>(1, std::size_t(columns));
  return std::min({std::max<std::size_t>(1, options.entry_limit / all), options.column_limit, all});
}

constexpr int lanes = 8; // number of doubles in the widest vector register

/// One value for each of some columns of a flow.
struct alignas(64) Lanes
{
  double values[lanes] = {};
};

/// Adds multiples of `count` entries of a column to the sums of their rows.
CGAL_SHAPE_CORRESPONDENCE_CLONED
void add_multiples(const double* entries, const int* rows, int count, const Lanes& weights, Lanes* __restrict sums)
{
  for (int k = 0; k < count; ++k) {
    double* const sum = sums[rows[k]].values;
    for (int c = 0; c < lanes; ++c)
      sum[c] += entries[k] * weights.values[c];
  }
}

/// Some columns of a squared flow, side by side, so that the processor adds up several at a time.
class Squared_columns
{
public:
  static constexpr std::size_t number = lanes;

  explicit Squared_columns(const Flow_matrix& flow)
      : flow_(flow), weights_(std::size_t(flow.rows())), sums_(weights_), is_reached_(weights_.size(), 0)
  {}

  /// \param wanted at most `number` of them \return the columns, with rows in any order
  std::vector<Column> operator()(const std::vector<Eigen::Index>& wanted)
  {
    std::vector<int> ways, rows;
    for (std::size_t c = 0; c < wanted.size(); ++c)
      for (Flow_matrix::InnerIterator way(flow_, wanted[c]); way; ++way) {
        reach(int(way.row()), ways);
        weights_[std::size_t(way.row())].values[c] = way.value();
      }
    std::sort(ways.begin(), ways.end());
    std::size_t additions = 0;
    for (int way : ways) {
      is_reached_[std::size_t(way)] = 0;
      additions += std::size_t(number_of_entries(way));
    }
    const bool may_reach_all = additions > sums_.size(); // then all rows are looked at, which takes less time
    for (int way : ways) {
      const int begin = flow_.outerIndexPtr()[way], count = number_of_entries(way);
      const int* const rows_of_way = flow_.innerIndexPtr() + begin;
      for (int k = 0; !may_reach_all && k < count; ++k)
        reach(rows_of_way[k], rows);
      add_multiples(flow_.valuePtr() + begin, rows_of_way, count, weights_[std::size_t(way)], sums_.data());
      weights_[std::size_t(way)] = {};
    }
    if (may_reach_all) {
      rows.resize(sums_.size());
      std::iota(rows.begin(), rows.end(), 0);
    }
    std::vector<Column> result(wanted.size());
    for (int row : rows) {
      const Lanes sums = std::exchange(sums_[std::size_t(row)], {});
      is_reached_[std::size_t(row)] = 0;
      for (std::size_t c = 0; c < wanted.size(); ++c)
        if (sums.values[c] > 0) result[c].emplace_back(row, sums.values[c]);
    }
    return result;
  }

private:
  int number_of_entries(int column) const { return flow_.outerIndexPtr()[column + 1] - flow_.outerIndexPtr()[column]; }

  void reach(int row, std::vector<int>& reached)
  {
    if (std::exchange(is_reached_[std::size_t(row)], 1) == 0) reached.push_back(row);
  }

  const Flow_matrix& flow_;
  std::vector<Lanes> weights_, sums_; // one for each row of the flow; all are zero between calls
  std::vector<char> is_reached_;      // whether a row is in a list
};

/// Keeps only the largest entries of a column (ties by row) above a threshold, and sorts them by row.
void prune(const Markov_clustering_options& options, std::size_t column_limit, Column& column)
{
  double most = 0;
  for (const auto& entry : column)
    most = std::max(most, entry.second);
  const double limit = std::min(options.expansion_limit, most);
  column.erase(std::remove_if(column.begin(), column.end(),
                              [&](const auto& entry) { return entry.second < limit || entry.second == 0; }),
               column.end());
  if (column.size() > column_limit) {
    const auto is_larger = [](const auto& a, const auto& b) {
      return std::pair(-a.second, a.first) < std::pair(-b.second, b.first);
    };
    std::nth_element(column.begin(), column.begin() + std::ptrdiff_t(column_limit), column.end(), is_larger);
    column.resize(column_limit);
  }
  std::sort(column.begin(), column.end());
}

/// The columns ordered by the row of their largest entries, so that those that flow the same way are neighbours.
std::vector<Eigen::Index> like_columns(const Flow_matrix& flow)
{
  std::vector<std::pair<int, Eigen::Index>> order; // for each column, the row of its largest entry, and the column
  for (Eigen::Index j = 0; j < flow.cols(); ++j) {
    double most = 0;
    int row = 0;
    for (Flow_matrix::InnerIterator entry(flow, j); entry; ++entry)
      if (entry.value() > most) most = entry.value(), row = int(entry.row());
    order.emplace_back(row, j);
  }
  std::sort(order.begin(), order.end());
  std::vector<Eigen::Index> result;
  for (const auto& [row, column] : order)
    result.push_back(column);
  return result;
}

/// Inflates a pruned column, which is not normalized then. \return its deviation from a column of equal entries, 0 to 1
double inflate(double inflation, Column& column)
{
  const double sum = sum_of(column);
  double most = 0, squares = 0;
  for (auto& entry : column) {
    const double share = entry.second / sum;
    most = std::max(most, share);
    squares += share * share;
    entry.second = std::pow(share, inflation);
  }
  return most - squares;
}

/// Expands (squares), prunes and inflates a flow.
/// \return the largest deviation of a column from one whose nonzero entries are equal, from 0 to 1
double step(const Markov_clustering_options& options, Flow_matrix& flow)
{
  constexpr std::size_t columns_at_a_time = 64;
  static_assert(columns_at_a_time % Squared_columns::number == 0);
  const std::size_t limit = column_limit(options, flow.cols());
  const std::vector<Eigen::Index> order = like_columns(flow);
  std::vector<Column> columns(order.size());
  std::vector<double> chaos(order.size());
  internal::for_each_index<CGAL::Parallel_if_available_tag>(
      (order.size() + columns_at_a_time - 1) / columns_at_a_time, [&](std::size_t block) {
        Squared_columns squared(flow);
        const std::size_t end = std::min(order.size(), (block + 1) * columns_at_a_time);
        for (std::size_t k = block * columns_at_a_time; k < end; k += Squared_columns::number) {
          const std::vector<Eigen::Index> wanted(order.begin() + std::ptrdiff_t(k),
                                                 order.begin() +
                                                     std::ptrdiff_t(std::min(end, k + Squared_columns::number)));
          std::vector<Column> found = squared(wanted);
          for (std::size_t c = 0; c < wanted.size(); ++c) {
            prune(options, limit, found[c]);
            chaos[std::size_t(wanted[c])] = inflate(options.inflation, found[c]);
            columns[std::size_t(wanted[c])] = Column(found[c].begin(), found[c].end()); // without spare memory
          }
        }
      });
  flow.setZero();
  for (std::size_t j = 0; j < columns.size(); ++j)
    append_column(std::exchange(columns[j], {}), flow, Eigen::Index(j));
  flow.finalize();
  return chaos.empty() ? 0 : *std::max_element(chaos.begin(), chaos.end());
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

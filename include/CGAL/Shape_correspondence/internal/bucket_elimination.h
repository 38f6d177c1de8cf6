// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_INTERNAL_BUCKET_ELIMINATION_H
#define CGAL_SHAPE_CORRESPONDENCE_INTERNAL_BUCKET_ELIMINATION_H

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

// A cost table over a few variables, each with the same number of labels. Variables are numbered by their position in
// the search order; `scope` is ascending, its last variable runs fastest.
struct Cost_table
{
  std::vector<std::size_t> scope;
  std::vector<double> values;

  double operator()(const std::vector<int>& labels, std::size_t number_of_labels) const
  {
    std::size_t index = 0;
    for (std::size_t v : scope)
      index = index * number_of_labels + std::size_t(labels[v]);
    return values[index];
  }
};

// Orders the vertices of a graph so that eliminating them from the back fills in few edges (min-fill, ties by index).
inline std::vector<std::size_t> min_fill_order(std::size_t n,
                                               const std::vector<std::pair<std::size_t, std::size_t>>& edges)
{
  std::vector<std::vector<char>> adjacent(n, std::vector<char>(n, 0));
  for (const auto& edge : edges)
    adjacent[edge.first][edge.second] = adjacent[edge.second][edge.first] = 1;
  std::vector<char> eliminated(n, 0);
  std::vector<std::size_t> order;
  const auto neighbours = [&](std::size_t v) {
    std::vector<std::size_t> result;
    for (std::size_t w = 0; w < n; ++w)
      if (adjacent[v][w] && !eliminated[w]) result.push_back(w);
    return result;
  };
  for (std::size_t step = 0; step < n; ++step) {
    std::size_t best = n, best_fill = 0;
    for (std::size_t v = 0; v < n; ++v) {
      if (eliminated[v]) continue;
      const auto around = neighbours(v);
      std::size_t fill = 0;
      for (std::size_t i = 0; i < around.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
          fill += !adjacent[around[i]][around[j]];
      if (best == n || fill < best_fill) best = v, best_fill = fill;
    }
    const auto around = neighbours(best);
    for (std::size_t a : around)
      for (std::size_t b : around)
        if (a != b) adjacent[a][b] = 1;
    eliminated[best] = 1;
    order.push_back(best);
  }
  std::reverse(order.begin(), order.end());
  return order;
}

// Mini-bucket elimination: lower bounds on the sum of cost tables for every partial assignment of a prefix of
// variables, exact as long as no bucket had to be split.
class Bucket_elimination
{
public:
  Bucket_elimination(std::size_t variables, std::size_t labels, std::size_t table_limit)
      : labels_(labels), table_limit_(table_limit), buckets_(variables), crossing_(variables)
  {}

  std::size_t variables() const { return buckets_.size(); }
  void add(Cost_table table) { buckets_[table.scope.back()].push_back(std::move(table)); }

  // Eliminates all variables from the last to the first.
  void run()
  {
    original_.resize(buckets_.size());
    for (std::size_t v = 0; v < buckets_.size(); ++v)
      original_[v] = buckets_[v].size();
    for (std::size_t v = buckets_.size(); v-- > 0;)
      for (const std::vector<std::size_t>& mini : mini_buckets(v))
        eliminate(v, mini);
  }

  // Lower bound on the sum of all tables over all assignments.
  double bound() const { return constant_; }

  // The sum of the original tables that became complete with variable v.
  double cost(std::size_t v, const std::vector<int>& labels) const
  {
    double sum = 0;
    for (std::size_t i = 0; i < original_[v]; ++i)
      sum += buckets_[v][i](labels, labels_);
    return sum;
  }

  // Lower bound on the sum of the tables that are not complete when variables up to v have labels.
  double remainder(std::size_t v, const std::vector<int>& labels) const
  {
    double sum = 0;
    for (const auto& place : crossing_[v])
      sum += buckets_[place.first][place.second](labels, labels_);
    return sum + floating_after(v);
  }

private:
  // Tables of a bucket, packed first-fit into sets whose joint table is small enough.
  std::vector<std::vector<std::size_t>> mini_buckets(std::size_t v) const
  {
    std::vector<std::size_t> order(buckets_[v].size());
    for (std::size_t i = 0; i < order.size(); ++i)
      order[i] = i;
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return buckets_[v][a].scope.size() > buckets_[v][b].scope.size();
    });
    std::vector<std::vector<std::size_t>> minis;
    std::vector<std::vector<std::size_t>> scopes;
    for (std::size_t i : order) {
      std::size_t fits = 0;
      for (; fits < minis.size(); ++fits)
        if (entries(united(scopes[fits], buckets_[v][i].scope).size()) <= table_limit_) break;
      if (fits == minis.size()) minis.emplace_back(), scopes.emplace_back();
      minis[fits].push_back(i);
      scopes[fits] = united(scopes[fits], buckets_[v][i].scope);
    }
    return minis;
  }

  static std::vector<std::size_t> united(const std::vector<std::size_t>& a, const std::vector<std::size_t>& b)
  {
    std::vector<std::size_t> result;
    std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
    return result;
  }

  std::size_t entries(std::size_t variables) const
  {
    std::size_t result = 1;
    while (variables-- > 0 && result <= table_limit_)
      result *= labels_;
    return result;
  }

  // Replaces tables that share variable v by their minimum over its labels.
  void eliminate(std::size_t v, const std::vector<std::size_t>& mini)
  {
    std::vector<std::size_t> scope;
    for (std::size_t i : mini)
      scope = united(scope, buckets_[v][i].scope);
    scope.pop_back(); // v, the greatest
    Cost_table message{scope, {}};
    std::size_t count = 1;
    for (std::size_t i = 0; i < scope.size(); ++i)
      count *= labels_;
    message.values.reserve(count);

    std::vector<int> labels(v + 1, 0);
    for (std::size_t entry = 0; entry < count; ++entry) {
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t l = 0; l < labels_; ++l) {
        labels[v] = int(l);
        double sum = 0;
        for (std::size_t i : mini)
          sum += buckets_[v][i](labels, labels_);
        least = std::min(least, sum);
      }
      message.values.push_back(least);
      for (std::size_t i = scope.size(); i-- > 0;) {
        if (++labels[scope[i]] < int(labels_)) break;
        labels[scope[i]] = 0;
      }
    }
    if (scope.empty()) {
      constants_.emplace_back(v, message.values[0]);
      constant_ += message.values[0];
      return;
    }
    const std::size_t to = scope.back();
    for (std::size_t level = to; level < v; ++level)
      crossing_[level].emplace_back(to, buckets_[to].size());
    buckets_[to].push_back(std::move(message));
  }

  // Messages without variables, of buckets behind v.
  double floating_after(std::size_t v) const
  {
    double sum = 0;
    for (const auto& constant : constants_)
      if (constant.first > v) sum += constant.second;
    return sum;
  }

  std::size_t labels_, table_limit_;
  std::vector<std::vector<Cost_table>> buckets_; // by last variable: original tables, then messages
  std::vector<std::size_t> original_;
  std::vector<std::vector<std::pair<std::size_t, std::size_t>>> crossing_; // messages from behind v to v or before
  std::vector<std::pair<std::size_t, double>> constants_;
  double constant_ = 0;
};

} // namespace internal
} // namespace Shape_correspondence
} // namespace CGAL

#endif

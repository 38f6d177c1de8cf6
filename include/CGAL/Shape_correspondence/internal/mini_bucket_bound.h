// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_INTERNAL_MINI_BUCKET_BOUND_H
#define CGAL_SHAPE_CORRESPONDENCE_INTERNAL_MINI_BUCKET_BOUND_H

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

// A cost table over a few variables, numbered by their position in the search order. `scope` is ascending; its last
// variable runs fastest, so that a row over it is contiguous.
struct Cost_table
{
  std::vector<std::size_t> scope;
  std::vector<double> values;
  std::vector<std::size_t> strides = {}; // by variable of the scope

  // The row over the last variable.
  const double* row(const std::vector<int>& labels) const
  {
    std::size_t offset = 0;
    for (std::size_t i = 0; i + 1 < scope.size(); ++i)
      offset += std::size_t(labels[scope[i]]) * strides[i];
    return values.data() + offset;
  }
  double value(const std::vector<int>& labels) const { return row(labels)[labels[scope.back()]]; }
};

// Mini-bucket elimination: lower bounds on the sum of cost tables for every partial assignment of a prefix of
// variables, exact as long as no bucket had to be split.
class Mini_bucket_bound
{
public:
  Mini_bucket_bound(std::vector<std::size_t> labels, std::size_t table_limit)
      : labels_(std::move(labels)), table_limit_(table_limit), buckets_(labels_.size()), levels_(labels_.size())
  {}

  void add(Cost_table table)
  {
    table.strides.assign(table.scope.size(), 1);
    for (std::size_t i = table.scope.size() - 1; i-- > 0;)
      table.strides[i] = table.strides[i + 1] * labels_[table.scope[i + 1]];
    buckets_[table.scope.back()].push_back(std::move(table));
  }

  // Eliminates all variables from the last to the first.
  void run()
  {
    std::vector<std::size_t> originals;
    for (const auto& bucket : buckets_)
      originals.push_back(bucket.size());
    for (std::size_t v = buckets_.size(); v-- > 0;) {
      const auto minis = mini_buckets(v);
      exact_ = exact_ && minis.size() <= 1;
      for (const std::vector<std::size_t>& mini : minis)
        eliminate(v, mini);
    }
    // What the bound of a level reads; tables do not move any more
    for (std::size_t v = 0; v < buckets_.size(); ++v)
      for (std::size_t i = 0; i < buckets_[v].size(); ++i)
        if (i < originals[v]) levels_[v].complete.push_back(&buckets_[v][i]);
    for (const Message& message : messages_)
      for (std::size_t v = message.bucket; v < message.from; ++v) {
        const Cost_table* table = &buckets_[message.bucket][message.index];
        (v == message.bucket ? levels_[v].arriving : levels_[v].passing).push_back(table);
      }
  }

  // Lower bound on the sum of all tables over all assignments.
  double bound() const { return constant_; }
  bool exact() const { return exact_; }

  // For every label of v, given labels of the variables before it: in `costs`, `cost` and the tables that become
  // complete with v; in `bounds`, that and a lower bound on all other tables.
  void extend(std::size_t v, const std::vector<int>& labels, double cost, double* costs, double* bounds) const
  {
    const std::size_t n = labels_[v];
    std::fill(costs, costs + n, cost);
    for (const Cost_table* table : levels_[v].complete)
      add_row(*table, labels, n, costs);
    double rest = levels_[v].constant;
    for (const Cost_table* table : levels_[v].passing)
      rest += table->value(labels);
    for (std::size_t l = 0; l < n; ++l)
      bounds[l] = costs[l] + rest;
    for (const Cost_table* table : levels_[v].arriving)
      add_row(*table, labels, n, bounds);
  }

private:
  struct Message
  {
    std::size_t from, bucket, index;
  };
  struct Level
  {
    std::vector<const Cost_table*> complete, arriving, passing;
    double constant = 0; // messages without variables, of buckets behind
  };

  static void add_row(const Cost_table& table, const std::vector<int>& labels, std::size_t n, double* sums)
  {
    const Eigen::Index count = Eigen::Index(n);
    Eigen::Map<Eigen::VectorXd>(sums, count) += Eigen::Map<const Eigen::VectorXd>(table.row(labels), count);
  }

  // Tables of a bucket, packed first-fit into sets whose joint table is small enough.
  std::vector<std::vector<std::size_t>> mini_buckets(std::size_t v) const
  {
    std::vector<std::size_t> order(buckets_[v].size());
    for (std::size_t i = 0; i < order.size(); ++i)
      order[i] = i;
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return buckets_[v][a].scope.size() > buckets_[v][b].scope.size();
    });
    std::vector<std::vector<std::size_t>> minis, scopes;
    for (std::size_t i : order) {
      std::size_t fits = 0;
      for (; fits < minis.size(); ++fits)
        if (entries(united(scopes[fits], buckets_[v][i].scope)) <= table_limit_) break;
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

  std::size_t entries(const std::vector<std::size_t>& scope) const
  {
    std::size_t result = 1;
    for (std::size_t v : scope)
      if (result <= table_limit_) result *= labels_[v];
    return result;
  }

  // Replaces tables that share variable v by their minimum over its labels.
  void eliminate(std::size_t v, const std::vector<std::size_t>& mini)
  {
    std::vector<std::size_t> scope;
    for (std::size_t i : mini)
      scope = united(scope, buckets_[v][i].scope);
    scope.pop_back(); // v, the greatest
    std::size_t count = 1;
    for (std::size_t u : scope)
      count *= labels_[u];
    Cost_table message{scope, {}};
    message.values.reserve(count);

    std::vector<int> labels(v + 1, 0);
    Eigen::VectorXd sums(Eigen::Index(labels_[v]));
    for (std::size_t entry = 0; entry < count; ++entry) {
      sums.setZero();
      for (std::size_t i : mini)
        add_row(buckets_[v][i], labels, labels_[v], sums.data());
      message.values.push_back(sums.minCoeff());
      for (std::size_t i = scope.size(); i-- > 0;) {
        if (++labels[scope[i]] < int(labels_[scope[i]])) break;
        labels[scope[i]] = 0;
      }
    }
    if (scope.empty()) {
      for (std::size_t level = 0; level < v; ++level)
        levels_[level].constant += message.values[0];
      constant_ += message.values[0];
      return;
    }
    messages_.push_back({v, scope.back(), buckets_[scope.back()].size()});
    add(std::move(message));
  }

  std::vector<std::size_t> labels_; // number of labels by variable
  std::size_t table_limit_;
  std::vector<std::vector<Cost_table>> buckets_; // by last variable: original tables, then messages
  std::vector<Message> messages_;
  std::vector<Level> levels_;
  double constant_ = 0;
  bool exact_ = true;
};

} // namespace internal
} // namespace Shape_correspondence
} // namespace CGAL

#endif

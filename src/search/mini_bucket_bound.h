// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_SEARCH_MINI_BUCKET_BOUND_H
#define CGAL_SHAPE_CORRESPONDENCE_SEARCH_MINI_BUCKET_BOUND_H

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

// A cost table over a few variables, numbered by their position in the search order. `scope` is ascending; its last
// variable runs fastest, so that a row over it is contiguous.
struct Cost_table
{
  std::vector<std::size_t> scope, strides; // by variable of the scope
  std::size_t begin = 0;                   // of its values among those of all tables

  // Where the row over the last variable begins.
  std::size_t row(const std::vector<int>& labels) const
  {
    std::size_t offset = begin;
    for (std::size_t i = 0; i + 1 < scope.size(); ++i)
      offset += std::size_t(labels[scope[i]]) * strides[i];
    return offset;
  }
};

// Mini-bucket elimination: lower bounds on the sum of cost tables for every partial assignment of a prefix of
// variables, exact as long as no bucket had to be split. Here is what the scopes of the tables determine.
class Mini_buckets
{
public:
  // Tables over `scopes`, for variables with `labels` labels; messages have at most `table_limit` entries jointly with
  // their variable.
  Mini_buckets(std::vector<std::size_t> labels, std::size_t table_limit, std::vector<std::vector<std::size_t>> scopes)
      : labels_(std::move(labels)), table_limit_(table_limit), levels_(labels_.size())
  {
    std::vector<std::vector<std::size_t>> buckets(labels_.size()); // tables by last variable
    for (std::vector<std::size_t>& scope : scopes) {
      buckets[scope.back()].push_back(tables_.size());
      levels_[scope.back()].complete.push_back(tables_.size());
      add(std::move(scope));
    }
    for (std::size_t v = buckets.size(); v-- > 0;) {
      const auto minis = mini_buckets(buckets[v]);
      exact_ = exact_ && minis.size() <= 1;
      for (const std::vector<std::size_t>& mini : minis) {
        std::vector<std::size_t> scope;
        for (std::size_t table : mini)
          scope = united(scope, tables_[table].scope);
        scope.pop_back(); // v, the greatest
        for (std::size_t level = scope.empty() ? 0 : scope.back(); level < v; ++level)
          (!scope.empty() && level == scope.back() ? levels_[level].arriving : levels_[level].passing)
              .push_back(tables_.size());
        if (!scope.empty()) buckets[scope.back()].push_back(tables_.size());
        eliminations_.push_back({v, mini, tables_.size()});
        add(std::move(scope));
      }
    }
  }

  bool exact() const { return exact_; }
  std::size_t number_of_tables() const { return tables_.size(); }

private:
  friend class Mini_bucket_bound;

  // Tables that share a variable are replaced by their minimum over its labels.
  struct Elimination
  {
    std::size_t variable;
    std::vector<std::size_t> tables;
    std::size_t message;
  };
  // Tables that the bound of a variable reads: the given ones that become complete with it, messages that arrive at it
  // and those that go past it to variables before.
  struct Level
  {
    std::vector<std::size_t> complete, arriving, passing;
  };

  void add(std::vector<std::size_t> scope)
  {
    Cost_table table;
    table.strides.assign(scope.size(), 1);
    table.begin = values_;
    std::size_t size = 1;
    for (std::size_t i = scope.size(); i-- > 0;) {
      table.strides[i] = size;
      size *= labels_[scope[i]];
    }
    table.scope = std::move(scope);
    values_ += size;
    tables_.push_back(std::move(table));
  }

  // Tables of a bucket, packed first-fit into sets whose joint table is small enough.
  std::vector<std::vector<std::size_t>> mini_buckets(std::vector<std::size_t> bucket) const
  {
    std::stable_sort(bucket.begin(), bucket.end(),
                     [&](std::size_t a, std::size_t b) { return tables_[a].scope.size() > tables_[b].scope.size(); });
    std::vector<std::vector<std::size_t>> minis, scopes;
    for (std::size_t table : bucket) {
      std::vector<std::size_t> scope;
      std::size_t fits = 0;
      for (; fits < minis.size(); ++fits) {
        scope = united(scopes[fits], tables_[table].scope);
        if (entries(scope) <= table_limit_) break;
      }
      if (fits == minis.size()) {
        minis.emplace_back();
        scopes.emplace_back();
        scope = tables_[table].scope;
      }
      minis[fits].push_back(table);
      scopes[fits] = std::move(scope);
    }
    return minis;
  }

  static std::vector<std::size_t> united(const std::vector<std::size_t>& a, const std::vector<std::size_t>& b)
  {
    std::vector<std::size_t> result;
    result.reserve(a.size() + b.size());
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

  std::vector<std::size_t> labels_; // number of labels by variable
  std::size_t table_limit_;
  std::vector<Cost_table> tables_; // the given ones, then messages
  std::vector<Elimination> eliminations_;
  std::vector<Level> levels_;
  std::size_t values_ = 0; // of all tables
  bool exact_ = true;
};

// The values.
class Mini_bucket_bound
{
public:
  explicit Mini_bucket_bound(const Mini_buckets& buckets)
      : buckets_(&buckets), values_(buckets.values_), labels_(buckets.labels_.size(), 0)
  {}

  // The values of a given table, to be set before run().
  double* values(std::size_t table) { return values_.data() + buckets_->tables_[table].begin; }

  // Eliminates all variables from the last to the first.
  void run()
  {
    bound_ = 0;
    for (const Mini_buckets::Elimination& elimination : buckets_->eliminations_)
      eliminate(elimination);
  }

  // Lower bound on the sum of all tables over all assignments.
  double bound() const { return bound_; }

  // For every label of v, given labels of the variables before it: in `costs`, `cost` and the tables that become
  // complete with v; in `bounds`, that and a lower bound on all other tables.
  void extend(std::size_t v, const std::vector<int>& labels, double cost, double* costs, double* bounds) const
  {
    const std::size_t n = buckets_->labels_[v];
    const Mini_buckets::Level& level = buckets_->levels_[v];
    std::fill(costs, costs + n, cost);
    for (std::size_t table : level.complete)
      add_row(buckets_->tables_[table].row(labels), n, costs);
    double rest = 0;
    for (std::size_t i : level.passing) {
      const Cost_table& table = buckets_->tables_[i];
      rest += values_[table.row(labels) + (table.scope.empty() ? 0 : std::size_t(labels[table.scope.back()]))];
    }
    for (std::size_t l = 0; l < n; ++l)
      bounds[l] = costs[l] + rest;
    for (std::size_t table : level.arriving)
      add_row(buckets_->tables_[table].row(labels), n, bounds);
  }

private:
  void add_row(std::size_t begin, std::size_t n, double* sums) const
  {
    for (std::size_t l = 0; l < n; ++l)
      sums[l] += values_[begin + l];
  }

  void eliminate(const Mini_buckets::Elimination& elimination)
  {
    const std::size_t n = buckets_->labels_[elimination.variable];
    const Cost_table& message = buckets_->tables_[elimination.message];
    double* values = values_.data() + message.begin;
    sums_.resize(n);
    std::fill(labels_.begin(), labels_.end(), 0);
    for (bool more = true; more; ++values) {
      std::fill(sums_.begin(), sums_.end(), 0.0);
      for (std::size_t table : elimination.tables)
        add_row(buckets_->tables_[table].row(labels_), n, sums_.data());
      *values = *std::min_element(sums_.begin(), sums_.end());
      more = false;
      for (std::size_t i = message.scope.size(); i-- > 0 && !more;) {
        int& label = labels_[message.scope[i]];
        more = ++label < int(buckets_->labels_[message.scope[i]]);
        if (!more) label = 0;
      }
    }
    if (message.scope.empty()) bound_ += values[-1];
  }

  const Mini_buckets* buckets_;
  std::vector<double> values_, sums_;
  std::vector<int> labels_;
  double bound_ = 0;
};

} // namespace internal
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_SEARCH_MINI_BUCKET_BOUND_H

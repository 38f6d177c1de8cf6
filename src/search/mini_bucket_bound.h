// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "base/deadline.h"

#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

// A cost table over a few variables, numbered by their position in the search order. `scope` is ascending; its last
// variable runs fastest, so that a row over it is contiguous.
struct Cost_table
{
  std::vector<std::size_t> scope, strides; // indexed by variable of the scope
  std::size_t begin = 0;                   // index of its first value among those of all tables

  // Index of the first entry of the row over the last variable.
  std::size_t row(const std::vector<int>& labels) const
  {
    std::size_t offset = begin;
    for (std::size_t i = 0; i + 1 < scope.size(); ++i)
      offset += std::size_t(labels[scope[i]]) * strides[i];
    return offset;
  }
};

// Mini-bucket elimination: lower bounds on the sum of cost tables for every partial assignment of a prefix of
// variables, exact if no bucket is split. This class holds what depends on the scopes of the tables alone.
class Mini_buckets
{
public:
  // Sets up tables over the variables in `scopes`, which have `labels` labels. A mini-bucket, the joint table of a
  // message and the variable it eliminates, has at most `table_limit` entries, or is one table. \throw Out_of_time
  Mini_buckets(std::vector<std::size_t> labels, std::size_t table_limit, std::vector<std::vector<std::size_t>> scopes,
               const Deadline& deadline = Deadline());

  bool exact() const { return exact_; }
  std::size_t number_of_tables() const { return tables_.size(); }
  std::size_t number_of_values() const { return values_; }

private:
  friend class Mini_bucket_bound;

  // Replaces tables that share a variable by a message: the minimum of their sum over its labels.
  struct Elimination
  {
    std::size_t variable;
    std::vector<std::size_t> tables;
    std::size_t message;
  };
  // Tables that add to the bound once a variable v has a label: `complete` are given tables whose last variable is v,
  // `arriving` are messages whose last variable is v, `passing` are messages from variables after v to ones before v.
  struct Level
  {
    std::vector<std::size_t> complete, arriving, passing;
  };

  void add(std::vector<std::size_t> scope);

  // Partitions the tables of a bucket into mini-buckets with small enough joint tables, by first fit.
  std::vector<std::vector<std::size_t>> mini_buckets(std::vector<std::size_t> bucket) const;

  std::size_t entries(const std::vector<std::size_t>& scope) const;

  std::vector<std::size_t> labels_; // number of labels, by variable
  std::size_t table_limit_;
  std::vector<Cost_table> tables_; // the given tables, then messages
  std::vector<Elimination> eliminations_;
  std::vector<Level> levels_;
  std::size_t values_ = 0; // number of values of all tables
  bool exact_ = true;
};

class Mini_bucket_bound
{
public:
  explicit Mini_bucket_bound(const Mini_buckets& buckets)
      : buckets_(&buckets), values_(buckets.values_), labels_(buckets.labels_.size(), 0)
  {}

  // The values of a given table, to be filled in before `run()`.
  double* values(std::size_t table) { return values_.data() + buckets_->tables_[table].begin; }

  // Computes the bound: eliminates all variables, from the last to the first. \throw Out_of_time
  void run(const Deadline& deadline = Deadline())
  {
    bound_ = 0;
    for (const Mini_buckets::Elimination& elimination : buckets_->eliminations_) {
      deadline.check();
      eliminate(elimination);
    }
  }

  double bound() const { return bound_; }

  // For every label of v, given labels of the earlier variables: `costs` receives `cost` plus the tables that become
  // complete with v; `bounds` a lower bound on that plus all other tables.
  void extend(std::size_t v, const std::vector<int>& labels, double cost, double* costs, double* bounds) const;

private:
  void add_row(std::size_t begin, std::size_t n, double* sums) const;

  void eliminate(const Mini_buckets::Elimination& elimination);

  const Mini_buckets* buckets_;
  std::vector<double> values_, sums_;
  std::vector<int> labels_;
  double bound_ = 0;
};

} // namespace CGAL::Shape_correspondence::internal

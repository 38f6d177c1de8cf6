// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "search/mini_bucket_bound.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace CGAL::Shape_correspondence::internal {

namespace {

std::vector<std::size_t> united(const std::vector<std::size_t>& a, const std::vector<std::size_t>& b)
{
  std::vector<std::size_t> result;
  result.reserve(a.size() + b.size());
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
  return result;
}

} // namespace

Mini_buckets::Mini_buckets(std::vector<std::size_t> labels, std::size_t table_limit,
                           std::vector<std::vector<std::size_t>> scopes, const Deadline& deadline)
    : labels_(std::move(labels)), table_limit_(table_limit), levels_(labels_.size())
{
  std::vector<std::vector<std::size_t>> buckets(labels_.size()); // tables by their last variable
  for (std::vector<std::size_t>& scope : scopes) {
    buckets[scope.back()].push_back(tables_.size());
    levels_[scope.back()].complete.push_back(tables_.size());
    add(std::move(scope));
  }
  for (std::size_t v = buckets.size(); v-- > 0;) {
    deadline.check();
    const auto minis = mini_buckets(buckets[v]);
    exact_ = exact_ && minis.size() <= 1;
    for (const std::vector<std::size_t>& mini : minis) {
      std::vector<std::size_t> scope;
      for (std::size_t table : mini)
        scope = united(scope, tables_[table].scope);
      scope.pop_back(); // removes v, the last variable
      for (std::size_t level = scope.empty() ? 0 : scope.back(); level < v; ++level)
        (!scope.empty() && level == scope.back() ? levels_[level].arriving : levels_[level].passing)
            .push_back(tables_.size());
      if (!scope.empty()) buckets[scope.back()].push_back(tables_.size());
      eliminations_.push_back({v, mini, tables_.size()});
      add(std::move(scope));
    }
  }
}

void Mini_buckets::add(std::vector<std::size_t> scope)
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

std::vector<std::vector<std::size_t>> Mini_buckets::mini_buckets(std::vector<std::size_t> bucket) const
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

std::size_t Mini_buckets::entries(const std::vector<std::size_t>& scope) const
{
  std::size_t result = 1;
  for (std::size_t v : scope)
    if (result <= table_limit_) result *= labels_[v];
  return result;
}

void Mini_bucket_bound::extend(std::size_t v, const std::vector<int>& labels, double cost, double* costs,
                               double* bounds) const
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

void Mini_bucket_bound::add_row(std::size_t begin, std::size_t n, double* sums) const
{
  for (std::size_t l = 0; l < n; ++l)
    sums[l] += values_[begin + l];
}

void Mini_bucket_bound::eliminate(const Mini_buckets::Elimination& elimination)
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

} // namespace CGAL::Shape_correspondence::internal

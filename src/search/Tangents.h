// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "base/deadline.h"
#include "search/mini_bucket_bound.h"

#include <CGAL/Shape_correspondence/Pairwise_energy.h>

#include <Eigen/Core>

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

// A term of two variables, the first of which comes earlier in the order.
struct Pair_cost
{
  std::size_t first, second;
  Eigen::MatrixXd cost;
};

// Sequential tree-reweighted message passing (TRW-S, Kolmogorov 2006): moves costs between terms that share a variable,
// so that the sum of the least costs of all terms rises while the cost of every assignment stays the same. When
// repeated for similar costs of the same variables, it starts from the last messages. Neither Boost nor CGAL provides
// it or mini-buckets; the exact search is tested against toulbar2.
class Message_passing
{
public:
  bool has_messages() const { return !pairs_of_.empty(); }

  // Moves costs, in `sweeps` passes forwards and backwards through the variables. \throw Out_of_time
  void operator()(std::vector<Eigen::VectorXd>& unary, std::vector<Pair_cost>& pairs, int sweeps,
                  const Deadline& deadline = Deadline());

private:
  struct Pairs_of
  {
    std::vector<std::size_t> forward, backward; // indices of a variable's pairs with later and with earlier variables
  };

  void start(const std::vector<Eigen::VectorXd>& unary, const std::vector<Pair_cost>& pairs);

  void pass(const Eigen::VectorXd& unary, const std::vector<Pair_cost>& pairs, std::size_t v, bool is_forward);

  std::vector<Pairs_of> pairs_of_; // indexed by variable
  // For each pair, the cost moved to its first and its second variable
  std::vector<Eigen::VectorXd> to_first_, to_second_;
  std::vector<Eigen::MatrixXd> transposed_; // transposed costs of each pair, second × first variable
  Eigen::VectorXd sum_, moved_;
};

// A lower bound of the energy: root terms, which are convex in Q, are replaced by tangents, which leaves a sum of unary
// and binary terms.
struct Tangent_bound
{
  Mini_bucket_bound tables;
  double offset = 0; // constant term of the bound

  double bound() const { return offset + tables.bound(); }
};

// Computes tangent bounds. Variables are numbered by their position in the order; the energy is kept by reference.
class Tangents
{
public:
  // \param order the search order of the variables \param table_limit see `Mini_buckets` \throw Out_of_time
  Tangents(const Pairwise_energy& energy, const std::vector<std::size_t>& order, std::size_t table_limit,
           const Deadline& deadline = Deadline());

  // Whether the bounds are the exact minima of the energy with tangents in place of root terms.
  bool exact() const { return buckets_->exact(); }
  // Number of tables, which grows with the number of buckets that are split.
  std::size_t number_of_tables() const { return buckets_->number_of_tables(); }
  // Number of entries of the tables of a bound.
  std::size_t number_of_values() const { return buckets_->number_of_values(); }

  Tangent_bound make() const { return {Mini_bucket_bound(*buckets_)}; }

  // Computes the bound by the tangents of the root terms at Q = `touched`. \throw Out_of_time
  void touch(const std::vector<double>& touched, Tangent_bound& bound);

private:
  void set_cost(std::size_t pair, const Eigen::MatrixXd& cost);

  const Pairwise_energy& energy_;
  const std::vector<std::size_t>& order_;
  const Deadline deadline_;
  std::unique_ptr<const Mini_buckets> buckets_;
  std::vector<char> is_turned_; // for each edge, whether its second variable comes first in the order
  std::vector<Eigen::VectorXd> unary_;
  std::vector<Pair_cost> pairs_;
  Message_passing pass_messages_;
};

// The search order of the variables; bucket elimination goes through it backwards.
// \throw Out_of_time
std::vector<std::size_t> elimination_order(const Pairwise_energy& energy, const Deadline& deadline = Deadline());

// Orders the vertices of a graph so that eliminating them from the back adds few edges (min-fill, ties by index).
// Boost.Graph has minimum degree only, which gave greater widths on 14 of 600 random graphs of 22 to 100 vertices, and
// a smaller one on one. \throw Out_of_time
std::vector<std::size_t> min_fill_order(std::size_t n, const std::vector<std::pair<std::size_t, std::size_t>>& edges,
                                        const Deadline& deadline = Deadline());

} // namespace CGAL::Shape_correspondence::internal

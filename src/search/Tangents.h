// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "search/message_passing.h"
#include "search/mini_bucket_bound.h"

#include <CGAL/Shape_correspondence/Pairwise_energy.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

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

  // Whether the bounds are exact minima of the tangent energy.
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

} // namespace CGAL::Shape_correspondence::internal

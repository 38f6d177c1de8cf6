// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "base/deadline.h"

#include <Eigen/Core>

#include <cstddef>
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
    std::vector<std::size_t> forward, backward; // its terms with later and with earlier variables
  };

  void start(const std::vector<Eigen::VectorXd>& unary, const std::vector<Pair_cost>& pairs);

  void pass(const Eigen::VectorXd& unary, const std::vector<Pair_cost>& pairs, std::size_t v, bool is_forward);

  std::vector<Pairs_of> pairs_of_; // indexed by variable
  // For each pair, the cost moved to its first and its second variable
  std::vector<Eigen::VectorXd> to_first_, to_second_;
  std::vector<Eigen::MatrixXd> transposed_; // costs, second × first
  Eigen::VectorXd sum_, moved_;
};

} // namespace CGAL::Shape_correspondence::internal

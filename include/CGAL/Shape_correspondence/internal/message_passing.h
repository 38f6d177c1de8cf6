// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_INTERNAL_MESSAGE_PASSING_H
#define CGAL_SHAPE_CORRESPONDENCE_INTERNAL_MESSAGE_PASSING_H

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

// A term of two variables, the first one before the second in the order.
struct Pair_cost
{
  std::size_t first, second;
  Eigen::MatrixXd cost;
};

// By pair, the cost moved to either variable.
struct Messages
{
  std::vector<Eigen::VectorXd> to_first, to_second;
};

// Sequential tree-reweighted message passing (TRW-S, Kolmogorov 2006): moves costs between terms that share a variable,
// so that the sum of the least costs of all terms rises and no assignment's cost changes. It goes on from `messages`,
// those of a similar problem; none at first.
inline void reparametrize(std::vector<Eigen::VectorXd>& unary, std::vector<Pair_cost>& pairs, int sweeps,
                          Messages& messages)
{
  const std::size_t n = unary.size();
  std::vector<std::vector<std::size_t>> forward(n), backward(n); // pairs to later and to earlier variables
  for (std::size_t e = 0; e < pairs.size(); ++e) {
    forward[pairs[e].first].push_back(e);
    backward[pairs[e].second].push_back(e);
  }
  auto& [to_first, to_second] = messages;
  if (to_first.empty())
    for (const Pair_cost& pair : pairs) {
      to_first.push_back(Eigen::VectorXd::Zero(pair.cost.rows()));
      to_second.push_back(Eigen::VectorXd::Zero(pair.cost.cols()));
    }

  Eigen::VectorXd sum, moved;
  const auto pass = [&, &to_first = to_first, &to_second = to_second](std::size_t v, bool is_forward) {
    sum = unary[v];
    for (std::size_t e : forward[v])
      sum += to_first[e];
    for (std::size_t e : backward[v])
      sum += to_second[e];
    sum /= double(std::max<std::size_t>(1, std::max(forward[v].size(), backward[v].size())));
    for (std::size_t e : is_forward ? forward[v] : backward[v]) {
      const Eigen::MatrixXd& cost = pairs[e].cost;
      Eigen::VectorXd& message = is_forward ? to_second[e] : to_first[e];
      moved = sum - (is_forward ? to_first[e] : to_second[e]);
      if (is_forward)
        for (Eigen::Index b = 0; b < cost.cols(); ++b)
          message[b] = (cost.col(b) + moved).minCoeff();
      else {
        message = cost.col(0).array() + moved[0];
        for (Eigen::Index b = 1; b < cost.cols(); ++b)
          message = message.array().min(cost.col(b).array() + moved[b]);
      }
      message.array() -= message.minCoeff();
    }
  };
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (std::size_t v = 0; v < n; ++v)
      pass(v, true);
    for (std::size_t v = n; v-- > 0;)
      pass(v, false);
  }

  for (std::size_t e = 0; e < pairs.size(); ++e) {
    unary[pairs[e].first] += to_first[e];
    unary[pairs[e].second] += to_second[e];
    pairs[e].cost.colwise() -= to_first[e];
    pairs[e].cost.rowwise() -= to_second[e].transpose();
  }
}

} // namespace internal
} // namespace Shape_correspondence
} // namespace CGAL

#endif

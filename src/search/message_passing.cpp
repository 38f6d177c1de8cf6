// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "search/message_passing.h"

#include <algorithm>

namespace CGAL::Shape_correspondence::internal {

void Message_passing::operator()(std::vector<Eigen::VectorXd>& unary, std::vector<Pair_cost>& pairs, int sweeps,
                                 const Deadline& deadline)
{
  if (!has_messages()) start(unary, pairs);
  for (std::size_t e = 0; e < pairs.size(); ++e)
    transposed_[e] = pairs[e].cost.transpose();
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (std::size_t v = 0; v < unary.size(); ++v)
      deadline.check(), pass(unary[v], pairs, v, true);
    for (std::size_t v = unary.size(); v-- > 0;)
      deadline.check(), pass(unary[v], pairs, v, false);
  }
  for (std::size_t e = 0; e < pairs.size(); ++e) {
    unary[pairs[e].first] += to_first_[e];
    unary[pairs[e].second] += to_second_[e];
    pairs[e].cost.colwise() -= to_first_[e];
    pairs[e].cost.rowwise() -= to_second_[e].transpose();
  }
}

void Message_passing::start(const std::vector<Eigen::VectorXd>& unary, const std::vector<Pair_cost>& pairs)
{
  pairs_of_.resize(unary.size());
  transposed_.resize(pairs.size());
  for (std::size_t e = 0; e < pairs.size(); ++e) {
    pairs_of_[pairs[e].first].forward.push_back(e);
    pairs_of_[pairs[e].second].backward.push_back(e);
    to_first_.push_back(Eigen::VectorXd::Zero(pairs[e].cost.rows()));
    to_second_.push_back(Eigen::VectorXd::Zero(pairs[e].cost.cols()));
  }
}

void Message_passing::pass(const Eigen::VectorXd& unary, const std::vector<Pair_cost>& pairs, std::size_t v,
                           bool is_forward)
{
  const Pairs_of& around = pairs_of_[v];
  sum_ = unary;
  for (std::size_t e : around.forward)
    sum_ += to_first_[e];
  for (std::size_t e : around.backward)
    sum_ += to_second_[e];
  sum_ /= double(std::max<std::size_t>(1, std::max(around.forward.size(), around.backward.size())));
  for (std::size_t e : is_forward ? around.forward : around.backward) {
    const Eigen::MatrixXd& cost = is_forward ? transposed_[e] : pairs[e].cost; // one column for each label of v
    Eigen::VectorXd& message = is_forward ? to_second_[e] : to_first_[e];
    moved_ = sum_ - (is_forward ? to_first_[e] : to_second_[e]);
    message = cost.col(0).array() + moved_[0];
    for (Eigen::Index l = 1; l < cost.cols(); ++l)
      message = message.array().min(cost.col(l).array() + moved_[l]);
    message.array() -= message.minCoeff();
  }
}

} // namespace CGAL::Shape_correspondence::internal

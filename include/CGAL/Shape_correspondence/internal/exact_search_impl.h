// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_INTERNAL_EXACT_SEARCH_IMPL_H
#define CGAL_SHAPE_CORRESPONDENCE_INTERNAL_EXACT_SEARCH_IMPL_H

#include <CGAL/Shape_correspondence/exact_search.h>
#include <CGAL/Shape_correspondence/internal/bucket_elimination.h>
#include <CGAL/Shape_correspondence/internal/quantized.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

// Energies closer than this are equal: the first solution found stays.
constexpr double energy_tolerance = 1e-9;

// The energy with E_s replaced by its tangent at the sum of squares q0: a sum of terms, nowhere above E.
// E_s = 1 - sqrt(q / n) for q = sum of S_i², and -sqrt is convex.
class Tangent_problem
{
public:
  Tangent_problem(const Matching_problem& problem, const std::vector<std::size_t>& order, double q0,
                  std::size_t table_limit)
      : buckets(order.size(), problem.number_of_labels(), table_limit)
  {
    const double n = double(order.size()), w = problem.weights().split;
    offset = w * (1 - std::sqrt(q0 / n) / 2);
    std::vector<std::size_t> position(problem.source().groups.size());
    for (std::size_t i = 0; i < order.size(); ++i)
      position[order[i]] = i;

    for (std::size_t i = 0; i < order.size(); ++i) {
      Cost_table table{{i}, {}};
      for (std::size_t l = 0; l < problem.number_of_labels(); ++l) {
        const double s = problem.label(order[i], l).solidity_ratio;
        table.values.push_back(problem.unary_cost(order[i])[Eigen::Index(l)] - w * s * s / (2 * std::sqrt(n * q0)));
      }
      buckets.add(std::move(table));
    }
    for (const Matching_problem::Edge& edge : problem.edges()) {
      const bool swap = position[edge.first] > position[edge.second];
      const Eigen::MatrixXd cost = swap ? Eigen::MatrixXd(edge.cost.transpose()) : edge.cost;
      Cost_table table{{position[swap ? edge.second : edge.first], position[swap ? edge.first : edge.second]}, {}};
      for (Eigen::Index a = 0; a < cost.rows(); ++a)
        for (Eigen::Index b = 0; b < cost.cols(); ++b)
          table.values.push_back(cost(a, b));
      buckets.add(std::move(table));
    }
    buckets.run();
  }

  double bound() const { return offset + buckets.bound(); }

  Bucket_elimination buckets;
  double offset;
};

// Depth-first branch and bound over the assignments whose tangent bound is below the incumbent's energy.
class Branch_and_bound
{
public:
  Branch_and_bound(const Matching_problem& problem, const std::vector<std::size_t>& order, std::size_t node_limit)
      : problem_(problem),
        order_(order),
        node_limit_(node_limit),
        assignment_(problem.source().groups.size(), unassigned)
  {}

  // With `first_leaf_only`, the solution that the bound leads to, without a proof.
  void run(const Tangent_problem& tangent, bool first_leaf_only, Search_result& best)
  {
    tangent_ = &tangent;
    best_ = &best;
    first_leaf_only_ = first_leaf_only;
    done_ = false;
    labels_.assign(order_.size(), 0);
    descend(0, tangent.offset);
  }

  std::size_t nodes() const { return nodes_; }
  bool finished() const { return nodes_ < node_limit_; }

private:
  void descend(std::size_t level, double cost)
  {
    if (level == order_.size()) return leaf();
    struct Child
    {
      double bound, cost;
      int label;
    };
    std::vector<Child> children;
    for (std::size_t l = 0; l < problem_.number_of_labels(); ++l) {
      labels_[level] = int(l);
      const double complete = cost + tangent_->buckets.cost(level, labels_);
      const double bound = complete + tangent_->buckets.remainder(level, labels_);
      if (bound < limit()) children.push_back({bound, complete, int(l)});
    }
    std::stable_sort(children.begin(), children.end(),
                     [](const Child& a, const Child& b) { return quantized(a.bound) < quantized(b.bound); });
    for (const Child& child : children) {
      if (done_ || child.bound >= limit()) continue;
      if (++nodes_ >= node_limit_) done_ = true;
      labels_[level] = child.label;
      assignment_[order_[level]] = child.label;
      descend(level + 1, child.cost);
    }
  }

  void leaf()
  {
    const double energy = problem_.energy(assignment_);
    if (best_->assignment.empty() || energy < best_->energy - energy_tolerance) {
      best_->assignment = assignment_;
      best_->energy = energy;
    }
    if (first_leaf_only_) done_ = true;
  }

  double limit() const
  {
    return best_->assignment.empty() || first_leaf_only_ ? std::numeric_limits<double>::infinity()
                                                         : best_->energy - energy_tolerance;
  }

  const Matching_problem& problem_;
  const std::vector<std::size_t>& order_;
  std::size_t node_limit_, nodes_ = 0;
  Assignment assignment_;
  std::vector<int> labels_;
  const Tangent_problem* tangent_ = nullptr;
  Search_result* best_ = nullptr;
  bool first_leaf_only_ = false, done_ = false;
};

inline std::vector<std::size_t> elimination_order(const Matching_problem& problem)
{
  const std::vector<std::size_t>& groups = problem.active_groups();
  const auto index = [&](std::size_t group) {
    return std::size_t(std::lower_bound(groups.begin(), groups.end(), group) - groups.begin());
  };
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  for (const Matching_problem::Edge& edge : problem.edges())
    edges.emplace_back(index(edge.first), index(edge.second));
  std::vector<std::size_t> order;
  for (std::size_t i : min_fill_order(groups.size(), edges))
    order.push_back(groups[i]);
  return order;
}

inline double squared_sum(const Matching_problem& problem, const Assignment& assignment)
{
  double sum = 0;
  for (std::size_t g : problem.active_groups()) {
    const double s = problem.label(g, std::size_t(assignment[g])).solidity_ratio;
    sum += s * s;
  }
  return sum;
}

} // namespace internal

CGAL_SHAPE_CORRESPONDENCE_INLINE Search_result exact_search(const Matching_problem& problem,
                                                            const Exact_options& options)
{
  constexpr int maximum_tangents = 5;
  const std::vector<std::size_t> order = internal::elimination_order(problem);
  internal::Branch_and_bound search(problem, order, options.node_limit);
  Search_result result;
  result.summary.method = "exact";
  result.summary.lower_bound = problem.lower_bound();

  // Each tangent touches at the solution that the one before led to; the first at no split at all
  double q0 = double(order.size()), best_q0 = q0, best_bound = -std::numeric_limits<double>::infinity();
  for (int i = 0; i < maximum_tangents; ++i) {
    const internal::Tangent_problem tangent(problem, order, q0, options.table_limit);
    if (tangent.bound() > best_bound) best_bound = tangent.bound(), best_q0 = q0;
    Search_result leaf;
    search.run(tangent, true, leaf);
    if (result.assignment.empty() || leaf.energy < result.energy - internal::energy_tolerance)
      result.assignment = leaf.assignment, result.energy = leaf.energy;
    const double touched = internal::squared_sum(problem, leaf.assignment);
    if (std::abs(touched - q0) < internal::energy_tolerance || touched <= 0) break;
    q0 = touched;
  }
  search.run(internal::Tangent_problem(problem, order, best_q0, options.table_limit), false, result);

  result.optimal = search.finished() && !problem.has_shortlists();
  // Rounding in the bound must not put it above the energy it proves
  result.summary.lower_bound =
      result.optimal ? result.energy : std::min(result.energy, std::max(result.summary.lower_bound, best_bound));
  result.summary.states = search.nodes();
  result.summary.evaluations = search.nodes();
  return result;
}

} // namespace Shape_correspondence
} // namespace CGAL

#endif

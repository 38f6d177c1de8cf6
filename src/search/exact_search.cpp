// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/deadline.h"
#include "base/quantized.h"
#include "energy/Matching_problem.h"
#include "search/Local_energy.h"
#include "search/Tangents.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/exact_search.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

namespace CGAL::Shape_correspondence {
using namespace internal;

namespace {

// Difference of energies below which they count as equal; the solution found first stays.
constexpr double energy_tolerance = 1e-9;

// Number of nodes without a proof after which the tables of the bound are enlarged
constexpr std::size_t patience = 1u << 16;
constexpr std::size_t table_growth = 16;         // factor by which the tables are enlarged
constexpr std::size_t largest_tables = 1u << 20; // largest number of entries of a table

// Checks the sizes and indices of an energy, and returns it.
const Pairwise_energy& checked(const Pairwise_energy& energy)
{
  const std::size_t n = energy.number_of_variables();
  const auto fits = [&](std::size_t e, const Eigen::MatrixXd& table) {
    return table.rows() == energy.unary[energy.edges[e].first].size() &&
           table.cols() == energy.unary[energy.edges[e].second].size();
  };
  for (const Eigen::VectorXd& costs : energy.unary)
    if (costs.size() == 0) throw Invalid_input("exact search: every variable needs a label at least");
  for (std::size_t e = 0; e < energy.edges.size(); ++e) {
    if (energy.edges[e].first >= energy.edges[e].second || energy.edges[e].second >= n)
      throw Invalid_input("exact search: an edge must name two of the variables, the smaller first");
    if (!fits(e, energy.edges[e].cost))
      throw Invalid_input("exact search: the table of an edge must have a row and a column for every label");
  }
  for (const Pairwise_energy::Root_term& term : energy.root_terms) {
    bool is_valid = term.unary.size() == n && (term.edge.empty() || term.edge.size() == energy.edges.size());
    for (std::size_t v = 0; is_valid && v < n; ++v)
      is_valid = term.unary[v].size() == energy.unary[v].size();
    for (std::size_t e = 0; is_valid && e < term.edge.size(); ++e)
      is_valid = fits(e, term.edge[e]);
    if (!is_valid) throw Invalid_input("exact search: a root term must have the sizes of the energy");
  }
  return energy;
}

} // namespace

class Exact_search::Impl
{
public:
  Impl(const Pairwise_energy& energy, const Exact_options& options)
      : energy_(checked(energy)),
        local_energy_(energy),
        options_(options),
        deadline_(limit_of(options)),
        table_limit_(options.table_limit)
  {
    if (options.solutions < 1) throw Invalid_input("exact search: at least one solution must be asked for");
    for (std::size_t v = 0; v < energy.number_of_variables(); ++v)
      maximum_labels_ = std::max(maximum_labels_, energy.number_of_labels(v));
    const std::size_t n = energy.number_of_variables();
    labels_.assign(n, 0);
    assignment_.assign(n, unassigned);
    costs_.resize(n * maximum_labels_);
    bounds_.resize(n * maximum_labels_);
    children_.resize(n * maximum_labels_);
    prepare();
  }

  Search_result run()
  {
    wanted_ = options_.solutions;
    std::size_t nodes = 0;
    stopped_ = is_late_;
    for (bool more = !is_late_; more;) {
      const std::size_t left = options_.node_limit - nodes;
      start(can_refine() ? std::min(left, patience) : left);
      descend(0, tangent_->offset);
      nodes += nodes_;
      more = stopped_ && !is_late_ && nodes_ >= node_limit_ && nodes < options_.node_limit;
      if (more) refine();
      more = more && !is_late_;
    }
    Search_result result;
    result.summary.method = "exact";
    result.solutions = solutions_;
    result.optimal = !stopped_ && !is_late_;
    result.out_of_time = is_late_;
    // Rounding must not put the bound above the energy
    result.summary.lower_bound =
        result.optimal ? result.best().energy : std::min(result.best().energy, std::max(energy_.lower_bound(), bound_));
    result.summary.states = result.summary.evaluations = nodes;
    return result;
  }

  std::vector<double> min_marginals(const Search_result& result)
  {
    check_result(result);
    std::vector<double> rises(energy_.number_of_variables(), std::numeric_limits<double>::infinity());
    wanted_ = 1;
    deadline_ = Deadline(limit_of(options_));
    is_late_ = is_late_ && !tangent_;
    if (is_late_) return std::vector<double>(rises.size(), std::numeric_limits<double>::quiet_NaN());
    for (std::size_t level = 0; level < order_.size(); ++level) {
      const std::size_t variable = order_[level];
      if (energy_.number_of_labels(variable) < 2) continue;
      forbidden_level_ = level;
      forbidden_label_ = result.best().assignment[variable];
      solutions_.clear();
      start(options_.node_limit / order_.size());
      descend(0, tangent_->offset);
      rises[variable] = std::max(0.0, solutions_.front().energy - result.best().energy);
    }
    forbidden_level_ = order_.size();
    return rises;
  }

private:
  static double limit_of(const Exact_options& options)
  {
    if (!(options.time_limit >= 0)) throw Invalid_input("exact search: the time limit must be a number of seconds");
    return options.time_limit > 0 ? options.time_limit : Deadline::never;
  }

  void check_result(const Search_result& result) const
  {
    const std::size_t n = energy_.number_of_variables();
    bool is_valid = !result.solutions.empty() && result.best().assignment.size() == n;
    for (std::size_t v = 0; is_valid && v < n; ++v)
      is_valid =
          result.best().assignment[v] >= 0 && std::size_t(result.best().assignment[v]) < energy_.number_of_labels(v);
    if (!is_valid)
      throw Invalid_input(
          "exact search: min-marginals are asked for of the result of another energy; give that of this one");
  }

  // Computes the bound; if there is no time for that, finds a solution without a bound.
  void prepare()
  {
    try {
      order_ = elimination_order(energy_, deadline_);
      tangents_ = std::make_unique<Tangents>(energy_, order_, table_limit_, deadline_);
      choose_tangent();
    } catch (const Out_of_time&) {
      is_late_ = true;
    }
    if (!solutions_.empty()) return;
    for (std::size_t v = 0; v < assignment_.size(); ++v)
      energy_.unary[v].minCoeff(&assignment_[v]);
    improve();
    keep();
  }

  // Computes tangents of the root terms, the first at the greatest sums (Q = n), each next one at the first solution
  // found with the one before, and keeps the one with the greatest bound.
  void choose_tangent()
  {
    constexpr int maximum_tangents = 5;
    wanted_ = options_.solutions;
    std::vector<double> touched;
    for (const Pairwise_energy::Root_term& term : energy_.root_terms)
      touched.push_back(term.count);
    Tangent_bound tangent = tangents_->make();
    for (int i = 0; i < maximum_tangents; ++i) {
      tangents_->touch(touched, tangent);
      bound_ = std::max(bound_, tangent.bound());
      start(options_.node_limit);
      current_ = &tangent.tables;
      first_leaf_only_ = true;
      descend(0, tangent.offset);
      first_leaf_only_ = false;
      if (i == 0)
        tangent_ = std::exchange(tangent, tangents_->make());
      else if (tangent.bound() > tangent_->bound())
        std::swap(tangent, *tangent_);
      if (!tangents_->exact()) improve();
      keep();
      bool moved = false;
      for (std::size_t r = 0; r < touched.size(); ++r) {
        const double sum = energy_.root_sum(energy_.root_terms[r], assignment_);
        moved = moved || (std::abs(sum - touched[r]) > energy_tolerance && sum > 0);
        if (sum > 0) touched[r] = sum;
      }
      if (!moved) break;
    }
  }

  void start(std::size_t node_limit)
  {
    current_ = tangent_ ? &tangent_->tables : nullptr;
    nodes_ = 0;
    node_limit_ = node_limit;
    stopped_ = false;
  }

  bool can_refine() const { return !tangents_->exact() && table_limit_ * table_growth <= largest_tables; }

  // Enlarges the tables, if possible, until fewer buckets are split.
  void refine()
  {
    while (can_refine()) {
      table_limit_ *= table_growth;
      try {
        auto finer = std::make_unique<Tangents>(energy_, order_, table_limit_, deadline_);
        if (finer->number_of_tables() == tangents_->number_of_tables()) continue;
        if (2 * sizeof(double) * finer->number_of_values() > most_bytes_of_tables) {
          table_limit_ = largest_tables; // stops growth
          return;
        }
        tangent_.reset();
        tangents_ = std::move(finer);
        return choose_tangent();
      } catch (const Out_of_time&) {
        is_late_ = true;
        return;
      }
    }
  }

  void descend(std::size_t level, double cost)
  {
    if (level == order_.size()) {
      keep();
      stopped_ = stopped_ || first_leaf_only_;
      return;
    }
    const std::size_t variable = order_[level], count = energy_.number_of_labels(variable);
    double* costs = costs_.data() + level * maximum_labels_;
    double* bounds = bounds_.data() + level * maximum_labels_;
    int* children = children_.data() + level * maximum_labels_;
    current_->extend(level, labels_, cost, costs, bounds);
    int* end = children;
    for (int l = 0; l < int(count); ++l)
      if (bounds[l] < limit() && !(level == forbidden_level_ && l == forbidden_label_)) *end++ = l;
    std::sort(children, end, [bounds](int a, int b) {
      const Steps first = quantized(bounds[a]), second = quantized(bounds[b]);
      return first != second ? first < second : a < b;
    });
    for (const int* child = children; child != end && !stopped_; ++child) {
      if (bounds[*child] >= limit()) continue;
      ++nodes_;
      check_limits();
      labels_[level] = assignment_[variable] = *child;
      descend(level + 1, costs[*child]);
    }
  }

  // Checks the limits, which apply only once there is a solution.
  void check_limits()
  {
    if (solutions_.empty() || first_leaf_only_) return;
    constexpr std::size_t interval = 1024; // number of nodes between two readings of the clock
    stopped_ = stopped_ || nodes_ >= node_limit_;
    is_late_ = is_late_ || (nodes_ % interval == 0 && deadline_.is_over());
    stopped_ = stopped_ || is_late_;
  }

  // Changes labels one at a time as long as the energy falls and time remains.
  void improve()
  {
    for (bool changed = true; changed;) {
      changed = false;
      for (std::size_t v = 0; v < assignment_.size() && !deadline_.is_over(); ++v) {
        const std::vector<double> rises = local_energy_.rises(v, assignment_);
        double least = 0;
        for (std::size_t l = 0; l < rises.size(); ++l)
          if (rises[l] < least - energy_tolerance) least = rises[l], assignment_[v] = int(l), changed = true;
      }
    }
  }

  // Inserts the current assignment into the best ones; of equal ones, the one found first stays first.
  void keep()
  {
    const double energy = energy_(assignment_);
    if (solutions_.size() == wanted_ && energy >= solutions_.back().energy - energy_tolerance) return;
    for (const Solution& solution : solutions_)
      if (solution.assignment == assignment_) return;
    if (solutions_.size() < wanted_) solutions_.emplace_back();
    solutions_.back().energy = energy;
    solutions_.back().assignment = assignment_;
    for (std::size_t i = solutions_.size() - 1; i > 0 && energy < solutions_[i - 1].energy - energy_tolerance; --i)
      std::swap(solutions_[i], solutions_[i - 1]);
  }

  double limit() const
  {
    return solutions_.size() < wanted_ || first_leaf_only_ ? std::numeric_limits<double>::infinity()
                                                           : solutions_.back().energy - energy_tolerance;
  }

  const Pairwise_energy& energy_;
  const Local_energy local_energy_;
  const Exact_options options_;
  Deadline deadline_;
  bool is_late_ = false;
  std::vector<std::size_t> order_;
  std::size_t table_limit_;
  std::unique_ptr<Tangents> tangents_;
  std::optional<Tangent_bound> tangent_;                    // the best tangent bound; none if there was no time for it
  double bound_ = -std::numeric_limits<double>::infinity(); // the greatest bound of all tangents
  const Mini_bucket_bound* current_ = nullptr;

  std::size_t maximum_labels_ = 0;
  std::vector<double> costs_, bounds_; // by level and label, see `Mini_bucket_bound::extend()`
  std::vector<int> children_;          // labels to try, by level
  std::vector<int> labels_;            // indexed by level
  Assignment assignment_;
  std::vector<Solution> solutions_; // the best `wanted_` solutions so far
  std::size_t wanted_ = 1;
  std::size_t forbidden_level_ = std::size_t(-1);
  int forbidden_label_ = unassigned;
  std::size_t nodes_ = 0, node_limit_ = 0;
  bool first_leaf_only_ = false, stopped_ = false;
};

Exact_search::Exact_search(const Pairwise_energy& energy, const Exact_options& options)
    : impl_(std::make_unique<Impl>(energy, options))
{}

Exact_search::~Exact_search() = default;

Search_result Exact_search::run() { return impl_->run(); }

std::vector<double> Exact_search::min_marginals(const Search_result& result) { return impl_->min_marginals(result); }

Search_result exact_search(const Pairwise_energy& energy, const Exact_options& options)
{
  return Exact_search(energy, options).run();
}

} // namespace CGAL::Shape_correspondence

// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "search/beam_search.h"
#include "base/quantized.h"
#include "search/Partial_energy.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

namespace CGAL::Shape_correspondence {
using namespace internal;

namespace {

// The order of assignment: first the group with most contacts, then always the one with most to groups assigned so far.
std::vector<std::size_t> assignment_order(const Aligned_shape::Graph& graph)
{
  const std::size_t n = num_vertices(graph);
  std::vector<std::size_t> degree(n, 0), to_placed(n, 0), order;
  for (const auto& edge : boost::make_iterator_range(edges(graph)))
    for (std::size_t group : {source(edge, graph), target(edge, graph)})
      degree[group] += graph[edge].contacts.size();

  std::vector<char> placed(n, 0);
  while (order.size() < n) {
    std::size_t best = n;
    for (std::size_t g = 0; g < n; ++g) {
      if (placed[g]) continue;
      if (best == n || std::make_pair(to_placed[g], degree[g]) > std::make_pair(to_placed[best], degree[best]))
        best = g;
    }
    order.push_back(best);
    placed[best] = 1;
    for (const auto& edge : boost::make_iterator_range(out_edges(best, graph)))
      to_placed[target(edge, graph)] += graph[edge].contacts.size();
  }
  return order;
}

// A partial solution with one more group assigned.
struct Expansion
{
  Steps energy; // quantized, so that indices settle ties
  std::size_t parent;
  int label;
  std::size_t rating; // index in `Expander::ratings_`

  bool operator<(const Expansion& other) const
  {
    return std::tie(energy, parent, label) < std::tie(other.energy, other.parent, other.label);
  }
};

// Expands a parent by all labels of a group: appends its `count` best expansions (k), except those that are not among
// the `most` best (K) of the level so far. Labels are rated by ascending lower bound, so that most need no full rating.
class Expander
{
public:
  Expander(Partial_energy& energy, std::size_t count, std::size_t most, const Deadline& deadline)
      : energy_(energy), count_(count), most_(most), deadline_(deadline)
  {}

  // Frees the ratings of the previous level.
  void start_level()
  {
    spare_.resize(ratings_.size());
    std::iota(spare_.begin(), spare_.end(), std::size_t(0));
  }

  Rating& rating(const Expansion& expansion) { return ratings_[expansion.rating]; }

  void operator()(std::size_t parent, Assignment& assignment, std::size_t group, int labels,
                  std::vector<Expansion>& level)
  {
    bounds_.clear();
    for (int label = 0; label < labels; ++label) {
      assignment[group] = label;
      bounds_.emplace_back(energy_.lower_bound(assignment, group), label);
    }
    std::sort(bounds_.begin(), bounds_.end());
    const std::size_t begin = level.size();
    const Steps kept_before = begin < most_ ? std::numeric_limits<Steps>::max() : nth_energy(level);
    for (const auto& [bound, label] : bounds_) {
      Steps worst = kept_before;
      if (level.size() == begin + count_) worst = std::min(worst, level.back().energy);
      // The limit is one grid step above the worst energy, since energies are rounded
      const double greatest = worst == std::numeric_limits<Steps>::max() ? std::numeric_limits<double>::infinity()
                                                                         : double(worst + 1) * comparison_grid;
      if (bound > greatest || (!level.empty() && deadline_.is_over())) break;
      assignment[group] = label;
      const double energy = energy_(assignment, group, bound, greatest);
      if (energy > greatest) continue;
      level.push_back({quantized(energy), parent, label, keep(energy_.rating())});
      std::sort(level.begin() + std::ptrdiff_t(begin), level.end());
      if (level.size() <= begin + count_) continue;
      spare_.push_back(level.back().rating);
      level.pop_back();
    }
    assignment[group] = unassigned;
  }

private:
  std::size_t keep(const Rating& rating)
  {
    if (spare_.empty()) {
      ratings_.push_back(rating);
      return ratings_.size() - 1;
    }
    const std::size_t place = spare_.back();
    spare_.pop_back();
    ratings_[place] = rating;
    return place;
  }

  // The energy of the worst of the `most_` best expansions.
  Steps nth_energy(const std::vector<Expansion>& level)
  {
    sorted_ = level;
    const auto nth = sorted_.begin() + std::ptrdiff_t(most_ - 1);
    std::nth_element(sorted_.begin(), nth, sorted_.end());
    return nth->energy;
  }

  Partial_energy& energy_;
  std::size_t count_, most_;
  const Deadline& deadline_;
  std::vector<std::pair<double, int>> bounds_; // lower bounds and labels
  std::vector<Expansion> sorted_;
  std::vector<Rating> ratings_;    // ratings of the expansions of a level
  std::vector<std::size_t> spare_; // indices of free ratings
};

struct Partial_solution
{
  Assignment assignment;
  Rating rating;
};

} // namespace

Search_result beam_search(const Matching_problem& problem, const Beam_options& options, const Deadline& deadline)
{
  if (options.beam_width < 1 || options.expansions < 1)
    throw Invalid_input("beam search: the beam width K and the number of expansions k must be at least 1");

  Search_result result;
  Partial_energy partial_energy(problem);
  Expander expand(partial_energy, std::size_t(options.expansions), std::size_t(options.beam_width), deadline);
  std::vector<Partial_solution> beam(1), next;
  beam[0] = {Assignment(problem.source().number_of_groups(), unassigned), partial_energy.rating()};
  std::vector<Expansion> level;
  for (std::size_t group : assignment_order(problem.source().graph)) {
    level.clear();
    expand.start_level();
    for (std::size_t parent = 0; parent < beam.size(); ++parent) {
      if (!level.empty() && (result.out_of_time = result.out_of_time || deadline.is_over())) break;
      partial_energy.set_parent(beam[parent].assignment, beam[parent].rating);
      const int labels = int(problem.number_of_labels(group));
      expand(parent, beam[parent].assignment, group, labels, level);
      result.summary.evaluations += std::size_t(labels);
    }
    std::sort(level.begin(), level.end());
    level.resize(std::min(level.size(), std::size_t(options.beam_width)));
    result.summary.states += level.size();
    next.resize(level.size());
    for (std::size_t i = 0; i < level.size(); ++i) {
      next[i].assignment = beam[level[i].parent].assignment;
      next[i].assignment[group] = level[i].label;
      std::swap(next[i].rating, expand.rating(level[i]));
    }
    beam.swap(next);
  }
  for (Partial_solution& solution : beam)
    result.solutions.push_back({problem.energy()(solution.assignment), std::move(solution.assignment)});
  result.summary.lower_bound = std::min(problem.energy().lower_bound(), result.best().energy);
  result.optimal = result.best().energy <= result.summary.lower_bound;
  return result;
}

} // namespace CGAL::Shape_correspondence

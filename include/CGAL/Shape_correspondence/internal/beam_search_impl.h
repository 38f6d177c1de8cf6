// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_INTERNAL_BEAM_SEARCH_IMPL_H
#define CGAL_SHAPE_CORRESPONDENCE_INTERNAL_BEAM_SEARCH_IMPL_H

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/beam_search.h>
#include <CGAL/Shape_correspondence/internal/quantized.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

// The order of assignment: the group with most contacts first, then always the one with most contacts to those before.
inline std::vector<std::size_t> assignment_order(const Matching_problem& problem)
{
  const std::vector<std::size_t>& groups = problem.active_groups();
  const std::size_t n = problem.source().groups.size();
  Eigen::MatrixXi contacts = Eigen::MatrixXi::Zero(n, n);
  for (const Matching_problem::Edge& edge : problem.edges())
    contacts(edge.first, edge.second) = contacts(edge.second, edge.first) = int(edge.contacts.size());
  const Eigen::VectorXi degree = contacts.rowwise().sum();

  std::vector<std::size_t> order;
  std::vector<char> placed(n, 0);
  Eigen::VectorXi to_placed = Eigen::VectorXi::Zero(n);
  while (order.size() < groups.size()) {
    std::size_t best = n;
    for (std::size_t g : groups) {
      if (placed[g]) continue;
      if (best == n || std::make_pair(to_placed[g], degree[g]) > std::make_pair(to_placed[best], degree[best]))
        best = g;
    }
    order.push_back(best);
    placed[best] = 1;
    to_placed += contacts.col(best);
  }
  return order;
}

// Rates partial solutions: contacts between assigned groups by the tables, others by rods with propagated parts.
class Partial_energy
{
public:
  explicit Partial_energy(const Matching_problem& problem)
      : problem_(problem),
        displacement_(3, problem.source().parts.size()),
        contact_displacement_(problem.source().contacts.size()),
        matched_(problem.source().groups.size()),
        energies_(problem.source().contacts.size())
  {}

  // The solution whose expansions are rated next.
  void set_parent(const Assignment& assignment)
  {
    parent_.clear();
    (*this)(assignment);
    parent_ = assignment;
    parent_displacement_ = displacement_;
    parent_energies_ = energies_;
  }

  double operator()(const Assignment& assignment)
  {
    const Aligned_shape& shape = problem_.source();
    for (std::size_t g = 0; g < matched_.size(); ++g)
      matched_[g] = assignment[g] != unassigned;
    move_contact_points(assignment);
    propagate(shape, matched_, contact_displacement_, displacement_);

    Energy_terms terms;
    for (std::size_t contact : problem_.active_contacts()) {
      const bool known = same_as_parent(contact, assignment);
      energies_[contact] = known ? parent_energies_[contact] : contact_energy(contact, assignment);
      terms.distortion += energies_[contact].distortion;
      terms.connectedness += energies_[contact].connectedness;
    }
    ratios_.clear();
    for (std::size_t g : problem_.active_groups())
      ratios_.push_back(matched_[g] ? problem_.label(g, std::size_t(assignment[g])).solidity_ratio : 1.0);
    terms.split = split_energy(ratios_);
    return weighted_sum(terms, problem_.weights());
  }

private:
  // An expansion changes little: far from the new label, contacts keep their energies
  bool same_as_parent(std::size_t contact, const Assignment& assignment) const
  {
    if (parent_.empty()) return false;
    const Aligned_shape& shape = problem_.source();
    for (std::size_t part : shape.contacts[contact].parts) {
      const std::size_t group = shape.group_of[part];
      if (assignment[group] != parent_[group]) return false;
      if (!matched_[group] && displacement_.col(Eigen::Index(part)) != parent_displacement_.col(Eigen::Index(part)))
        return false;
    }
    return true;
  }

  const std::vector<std::size_t>& images(const Assignment& assignment, std::size_t part) const
  {
    const Aligned_shape& shape = problem_.source();
    const std::size_t group = shape.group_of[part];
    const auto& members = shape.groups[group].parts;
    const auto member = std::lower_bound(members.begin(), members.end(), part) - members.begin();
    return problem_.label(group, std::size_t(assignment[group])).images[std::size_t(member)];
  }

  // A contact point of a part with clones moves by their mean
  void move_contact_points(const Assignment& assignment)
  {
    const Aligned_shape& shape = problem_.source();
    for (std::size_t c : problem_.active_contacts())
      for (int side : {0, 1}) {
        const std::size_t part = shape.contacts[c].parts[side];
        if (!matched_[shape.group_of[part]]) continue;
        const Points& samples = shape.parts[part].samples;
        const auto& clones = images(assignment, part);
        Point sum = Point::Zero();
        for (std::size_t image : clones) {
          const Points& deformed = problem_.deformed(part, image);
          const Eigen::Index lift = deformed.cols() / samples.cols();
          sum += deformed.col(Eigen::Index(shape.contacts[c].samples[side]) * lift);
        }
        contact_displacement_[c][side] =
            sum / double(clones.size()) - samples.col(Eigen::Index(shape.contacts[c].samples[side]));
      }
  }

  Rod_energy contact_energy(std::size_t contact, const Assignment& assignment) const
  {
    const Aligned_shape& shape = problem_.source();
    const auto& parts = shape.contacts[contact].parts;
    const std::size_t g = shape.group_of[parts[0]], h = shape.group_of[parts[1]];
    if (matched_[g] && matched_[h])
      return problem_.contact_energy(contact, std::size_t(assignment[g]), std::size_t(assignment[h]));

    // Parts that move alike keep their rods
    const bool alike = (displacement_.col(parts[0]) - displacement_.col(parts[1])).squaredNorm() < zero_squared_length;
    if (!matched_[g] && !matched_[h] && alike) return {};

    const Points moved_first = shape.parts[parts[0]].samples.colwise() + displacement_.col(parts[0]);
    const Points moved_second = shape.parts[parts[1]].samples.colwise() + displacement_.col(parts[1]);
    if (!matched_[g] && !matched_[h])
      return problem_.rods(contact, moved_first.cols(), moved_second.cols()).energy(moved_first, moved_second);

    // One side is assigned: the propagated part keeps to the nearest of its clones
    const int side = matched_[g] ? 0 : 1;
    Rod_energy best;
    double best_cost = std::numeric_limits<double>::infinity();
    for (std::size_t image : images(assignment, parts[side])) {
      const Points& deformed = problem_.deformed(parts[side], image);
      const Points& first = side == 0 ? deformed : moved_first;
      const Points& second = side == 0 ? moved_second : deformed;
      const Rod_energy energy = problem_.rods(contact, first.cols(), second.cols()).energy(first, second);
      const double cost = energy.distortion + problem_.weights().connectedness * energy.connectedness;
      if (cost < best_cost) best = energy, best_cost = cost;
    }
    return best;
  }

  const Matching_problem& problem_;
  Points displacement_;
  std::vector<std::array<Point, 2>> contact_displacement_;
  std::vector<char> matched_;
  std::vector<double> ratios_;
  std::vector<Rod_energy> energies_;
  Assignment parent_; // empty: none
  Points parent_displacement_;
  std::vector<Rod_energy> parent_energies_;
};

struct Beam_state
{
  long energy; // quantized, so that ties are settled by the labels
  Assignment assignment;

  bool operator<(const Beam_state& other) const
  {
    return energy != other.energy ? energy < other.energy : assignment < other.assignment;
  }
};

inline void keep_best(std::vector<Beam_state>& states, std::size_t count)
{
  std::sort(states.begin(), states.end());
  if (states.size() > count) states.resize(count);
}

} // namespace internal

CGAL_SHAPE_CORRESPONDENCE_INLINE Search_result beam_search(const Matching_problem& problem, const Beam_options& options)
{
  using internal::Beam_state;
  if (options.beam_width < 1 || options.expansions < 1)
    throw Invalid_input("beam search: the beam width K and the number of expansions k must be at least 1");

  Search_result result;
  result.summary.lower_bound = problem.lower_bound();
  internal::Partial_energy partial_energy(problem);
  std::vector<Beam_state> beam{{0, Assignment(problem.source().groups.size(), unassigned)}};
  for (std::size_t group : internal::assignment_order(problem)) {
    std::vector<Beam_state> level;
    for (const Beam_state& state : beam) {
      std::vector<Beam_state> expansions;
      partial_energy.set_parent(state.assignment);
      for (std::size_t label = 0; label < problem.number_of_labels(); ++label) {
        Beam_state next{0, state.assignment};
        next.assignment[group] = int(label);
        next.energy = internal::quantized(partial_energy(next.assignment));
        expansions.push_back(std::move(next));
      }
      result.summary.evaluations += expansions.size();
      internal::keep_best(expansions, std::size_t(options.expansions));
      level.insert(level.end(), expansions.begin(), expansions.end());
    }
    internal::keep_best(level, std::size_t(options.beam_width));
    result.summary.states += level.size();
    beam = std::move(level);
  }
  result.assignment = beam.front().assignment;
  result.energy = problem.energy(result.assignment);
  result.optimal = result.energy <= result.summary.lower_bound && !problem.has_shortlists();
  return result;
}

} // namespace Shape_correspondence
} // namespace CGAL

#endif

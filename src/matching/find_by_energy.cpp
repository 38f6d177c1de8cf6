// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/limits.h"
#include "base/quantized.h"
#include "matching/Correspondence_finder_impl.h"
#include "matching/coarse_to_fine.h"
#include "matching/rate.h"

#include <CGAL/Shape_correspondence/exact_search.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace CGAL::Shape_correspondence {
using namespace internal;

namespace {

// The number of pairs of connected parts and of isolated parts.
std::size_t number_of_counted_pairs(const Aligned_shape& shape)
{
  std::vector<char> touches(shape.parts.size(), 0);
  for (const Aligned_shape::Contact& contact : shape.contacts)
    touches[contact.parts[0]] = touches[contact.parts[1]] = 1;
  const auto alone = std::size_t(std::count(touches.begin(), touches.end(), 0));
  return std::max<std::size_t>(1, shape.contacts.size() + alone);
}

constexpr int automatic_coarse_parts = 50; // number of largest parts, matched first if not all can be matched at once

// Whether a shape has more groups than a method can deform at once.
bool has_too_many_groups(const Aligned_shape& deformed, Search_method method)
{
  return deformed.number_of_groups() > (method == Search_method::BEAM ? most_beam_groups : most_exact_groups);
}

// A lower bound of the energy; 0 if its tables would take too much memory.
double least_energy_of(const Matching_problem::Shared_shape& deformed, const Matching_problem::Shared_shape& other,
                       const Energy_options& options)
{
  try {
    return Matching_problem(deformed, other, options).energy().lower_bound();
  } catch (const Too_large&) {
    return 0;
  }
}

Search_options backward(Search_options options)
{
  options.energy = reversed(std::move(options.energy));
  return options;
}

Matching_problem problem_of(const Matching_problem::Shared_shape& source, const Matching_problem::Shared_shape& target,
                            const Search_options& options, const Deadline& deadline)
{
  return {source, target, options.energy, coarse_candidates(source, target, options, deadline), deadline};
}

// \throw Out_of_time, Too_large if time or memory does not suffice for the tables
Search_run search(const Matching_problem::Shared_shape& source, const Matching_problem::Shared_shape& target,
                  Direction direction, int turns, const Search_options& options, const Deadline& deadline)
{
  Search_run run{direction == Direction::SOURCE_TO_TARGET ? problem_of(source, target, options, deadline)
                                                          : problem_of(target, source, backward(options), deadline),
                 direction,
                 turns,
                 is_coarse_to_fine(*source, *target, options) ? std::size_t(options.coarse_to_fine) : 0,
                 {}};
  run.result = search(run.problem, options, deadline);
  return run;
}

// The score by which runs are compared: the energy, or the energy per pair of connected parts.
Steps score(const Search_run& run, bool by_energy)
{
  double energy = run.result.best().energy;
  if (!by_energy) energy /= double(std::max<std::size_t>(1, run.problem.source().contacts.size()));
  return quantized(energy);
}

// Whether a label breaks the paper's rule that a group becomes a group or a self-symmetric part.
bool merges_into_asymmetric_part(const Matching_problem& problem, const Assignment& assignment)
{
  for (std::size_t g = 0; g < assignment.size(); ++g) {
    const std::size_t label = std::size_t(assignment[g]);
    if (problem.is_unmatched(g, label)) continue;
    const std::size_t first_part = problem.source().original[problem.source().group(g).parts[0]];
    const std::vector<Part_pair>& pinned = problem.options().pinned;
    if (std::any_of(pinned.begin(), pinned.end(), [&](const Part_pair& pin) { return pin.source == first_part; }))
      continue;
    if (!may_match(problem.source().group(g), problem.target().group(problem.label(g, label).target_group)))
      return true;
  }
  return false;
}

// \param min_marginals by group; may be empty
Correspondence correspondence_of(const Search_run& run, const Assignment& assignment,
                                 const std::vector<double>& min_marginals)
{
  Correspondence result = rate(run.problem, assignment, run.direction, run.turns, min_marginals);
  result.optimal = run.result.optimal;
  result.search = run.result.summary;
  if (run.coarse_parts > 0)
    result.warnings.push_back("The " + std::to_string(run.coarse_parts) +
                              " largest parts were matched first; the others were matched about them.");
  else if (run.problem.has_shortlists())
    result.warnings.push_back("There are " + std::to_string(run.problem.target().number_of_groups()) +
                              " groups to choose from; each was given the " + std::to_string(maximum_labels) +
                              " nearest in place and size to choose from.");
  if (merges_into_asymmetric_part(run.problem, assignment))
    result.warnings.push_back("A group of parts was merged into one part that is not symmetric by itself: there "
                              "is neither a group nor a symmetric part that it could have become.");
  return result;
}

} // namespace

Search_options Correspondence_finder::Impl::with_role_costs(const Prepared_shape& target, Correspondence& result) const
{
  Search_options options = options_;
  if (!(options.energy.weights.roles > 0) || !options.roles || options.energy.role_costs.size() > 0) return options;
  Pair_category category;
  const Alignment_candidate alignment = candidates(target, category).front();
  if (const std::optional<Role_votes_of_pair> votes = votes_of(target, category, alignment, result))
    options.energy.role_costs = 1 - agreement_of_votes(*votes->front(), *votes->back()).array();
  return options;
}

Search_runs Correspondence_finder::Impl::runs(const Prepared_shape& target, const Search_options& options,
                                              const Deadline& deadline) const
{
  const std::vector<int> turns = tried_turns(target);
  std::vector<Direction> directions{Direction::SOURCE_TO_TARGET};
  if (options_.both_directions) directions.push_back(Direction::TARGET_TO_SOURCE);
  Search_runs result;
  result.count = turns.size() * directions.size();
  for (int turn : turns) {
    const Shared_shape shape = aligned(target, turn);
    for (Direction direction : directions) {
      if (options_.progress && !options_.progress(double(result.done) / double(result.count))) {
        result.end = search_was_cancelled;
        return result;
      }
      try {
        auto run = std::make_unique<Search_run>(search(source_, shape, direction, turn, options, deadline));
        ++result.done;
        result.states += run->result.summary.states;
        result.evaluations += run->result.summary.evaluations;
        if (run->result.out_of_time && deadline.is_over()) result.end = time_is_over;
        const bool by_energy = options.direction_by_energy;
        if (!result.best || score(*run, by_energy) < score(*result.best, by_energy)) result.best = std::move(run);
      } catch (const Out_of_time&) {
        result.end = time_is_over;
      } catch (const Too_large& error) {
        result.too_large = error.what();
      }
      if (!result.end.empty()) return result;
    }
  }
  return result;
}

std::vector<Correspondence> Correspondence_finder::Impl::correspondences_of(const Search_runs& runs,
                                                                            const Deadline& deadline) const
{
  std::vector<double> min_marginals;
  if (options_.min_marginals && !deadline.is_over())
    min_marginals =
        Exact_search(runs.best->problem.energy(), until(deadline, options_.exact)).min_marginals(runs.best->result);
  std::vector<Correspondence> result;
  for (const Solution& solution : runs.best->result.solutions)
    result.push_back(
        correspondence_of(*runs.best, solution.assignment, result.empty() ? min_marginals : std::vector<double>()));
  return result;
}

Correspondence Correspondence_finder::Impl::by_costs(const Prepared_shape& target, const Search_runs& runs,
                                                     const Deadline& limit) const
{
  const Deadline fast = runs.end.empty() ? limit : Deadline(small_time);
  Correspondence result = rated(source_, matched_parts(target, fast), fast);
  result.complete = result.complete && runs.end.empty();
  result.warnings.push_back((runs.end.empty() ? "The search would " + runs.too_large
                                              : std::string(time_is_over) + " before it had found anything") +
                            "; parts were matched by their costs in its place.");
  return result;
}

std::vector<Correspondence> Correspondence_finder::Impl::least_energy(const Prepared_shape& target) const
{
  const Deadline limit = deadline();
  Correspondence known;
  Search_options options = with_role_costs(target, known);
  if (options.coarse_to_fine == 0 &&
      (has_too_many_groups(*source_, options.method) ||
       (options.both_directions && has_too_many_groups(*aligned(target, 0), options.method))))
    options.coarse_to_fine = automatic_coarse_parts;
  Search_runs searched = runs(target, options, limit);
  if (options.coarse_to_fine == 0 && !searched.best && searched.end.empty()) { // there was too little memory
    options.coarse_to_fine = automatic_coarse_parts;
    searched = runs(target, options, limit);
  }
  std::vector<Correspondence> result;
  if (searched.best)
    result = correspondences_of(searched, limit);
  else if (searched.end == search_was_cancelled)
    result.emplace_back();
  else
    return {by_costs(target, searched, limit)};
  for (Correspondence& correspondence : result) {
    correspondence.search.states = searched.states;
    correspondence.search.evaluations = searched.evaluations;
    take_roles(known, correspondence);
    if (!searched.end.empty()) mark_ended(searched.end, searched.done, searched.count, correspondence);
    if (!searched.too_large.empty()) {
      correspondence.optimal = false;
      correspondence.warnings.push_back("To deform one of the shapes would " + searched.too_large +
                                        "; only the other one was deformed.");
    }
  }
  return result;
}

double Correspondence_finder::Impl::lower_bound(const Prepared_shape& target, double unmatched_energy) const
{
  if (has_no_pairs(target)) return 0;
  const bool both_directions = options_.both_directions && options_.method != Search_method::PARTS;
  double bound = std::numeric_limits<double>::infinity();
  for (int turn : tried_turns(target)) {
    const Shared_shape shape = aligned(target, turn);
    bound = std::min(bound, lower_bound(source_, shape, unmatched_energy));
    if (both_directions) bound = std::min(bound, lower_bound(shape, source_, unmatched_energy));
  }
  constexpr double rounding = 1e-9; // relative and absolute margin, since sums are added up in another order
  return std::max(0., bound * (1 - rounding) - rounding);
}

double Correspondence_finder::Impl::lower_bound(const Shared_shape& deformed, const Shared_shape& other,
                                                double unmatched_energy) const
{
  const double pairs = double(number_of_counted_pairs(*deformed));
  if (options_.method != Search_method::PARTS)
    return least_energy_of(deformed, other, deformed == source_ ? options_.energy : reversed(options_.energy)) / pairs;
  if (options_.energy.norm == Energy_norm::POOLED) return 0;
  Energy_options energy = options_.energy;
  energy.cut_curves = false;
  energy.pinned.clear(); // dropping constraints cannot raise the least energy
  energy.forbidden.clear();
  energy.role_costs.resize(0, 0);
  energy.unmatched_cost = unmatched_energy;
  if (other->parts.size() > maximum_labels) return 0; // not every part could be a label
  return least_energy_of(std::make_shared<Deformable_shape>(deformed->ungrouped()),
                         std::make_shared<Deformable_shape>(other->ungrouped()), energy) /
         pairs;
}

} // namespace CGAL::Shape_correspondence

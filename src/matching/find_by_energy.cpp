// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/limits.h"
#include "base/quantized.h"
#include "matching/Match_task.h"
#include "matching/coarse_to_fine.h"
#include "matching/rate.h"

#include <CGAL/Shape_correspondence/exact_search.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace CGAL::Shape_correspondence::internal {

namespace {

// One run of a search. The source of its problem is the shape that is deformed.
struct Search_run
{
  Matching_problem problem;
  Direction direction;
  int turns; // by how many quarter turns about the up axis the target is turned
  std::size_t
      coarse_parts; // number of the largest parts that were matched before the others; 0: all are matched at once
  Search_result result;
};

// The runs of a search for the least energy; the best one is kept.
struct Search_runs
{
  std::unique_ptr<const Search_run> best;
  std::size_t states = 0, evaluations = 0, done = 0, count = 0; // sums over the runs; runs done, and to be done
  std::string end;                                              // why runs are missing; empty if all were done
  std::string too_large; // message about runs whose tables exceed the memory; empty if there are none
};

// The number of pairs of connected parts plus the number of isolated parts, by which `distance_energy()` divides.
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
double least_energy_of(const Shared_shape& deformed, const Shared_shape& other, const Energy_options& options)
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

Matching_problem problem_of(const Shared_shape& source, const Shared_shape& target, const Search_options& options,
                            const Deadline& deadline)
{
  return {source, target, options.energy, coarse_candidates(source, target, options, deadline), deadline};
}

// Searches in one alignment and direction. \throw Out_of_time, Too_large if time or memory is too little for tables
Search_run search(const Shared_shape& source, const Shared_shape& target, Direction direction, int turns,
                  const Search_options& options, const Deadline& deadline)
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

// The correspondence of an assignment, with warnings. \param min_marginals by group; may be empty
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

// The options with `Energy_options::role_costs`, if roles are wanted and known. \param result see `votes_of()`
Search_options with_role_costs(const Match_task& task, Correspondence& result)
{
  Search_options options = task.options;
  if (!(options.energy.weights.roles > 0) || !options.roles || options.energy.role_costs.size() > 0) return options;
  Pair_category category;
  const Alignment_candidate alignment = candidates(task, category).front();
  if (const std::optional<Role_votes_of_pair> votes = votes_of(task, category, alignment, result))
    options.energy.role_costs = 1 - agreement_of_votes(*votes->front(), *votes->back()).array();
  return options;
}

Search_runs runs(const Match_task& task, const Search_options& options, const Deadline& deadline)
{
  const std::vector<int> turns = tried_turns(task);
  std::vector<Direction> directions{Direction::SOURCE_TO_TARGET};
  if (task.options.both_directions) directions.push_back(Direction::TARGET_TO_SOURCE);
  Search_runs result;
  result.count = turns.size() * directions.size();
  for (int turn : turns) {
    const Shared_shape shape = aligned_target(task, turn);
    for (Direction direction : directions) {
      if (task.options.progress && !task.options.progress(double(result.done) / double(result.count))) {
        result.end = search_was_cancelled;
        return result;
      }
      try {
        auto run = std::make_unique<Search_run>(search(task.aligned_source, shape, direction, turn, options, deadline));
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

std::vector<Correspondence> correspondences_of(const Match_task& task, const Search_runs& runs,
                                               const Deadline& deadline)
{
  std::vector<double> min_marginals;
  if (task.options.min_marginals && !deadline.is_over())
    min_marginals =
        Exact_search(runs.best->problem.energy(), until(deadline, task.options.exact)).min_marginals(runs.best->result);
  std::vector<Correspondence> result;
  for (const Solution& solution : runs.best->result.solutions)
    result.push_back(
        correspondence_of(*runs.best, solution.assignment, result.empty() ? min_marginals : std::vector<double>()));
  return result;
}

// The match of parts by costs, for when there is no time or memory for any run of the search.
Correspondence by_costs(const Match_task& task, const Search_runs& runs, const Deadline& limit)
{
  const Deadline fast = runs.end.empty() ? limit : Deadline(small_time);
  Correspondence result = rated(task.aligned_source, matched_parts(task, fast), task.options, fast);
  result.complete = result.complete && runs.end.empty();
  result.warnings.push_back((runs.end.empty() ? "The search would " + runs.too_large
                                              : std::string(time_is_over) + " before it had found anything") +
                            "; parts were matched by their costs in its place.");
  return result;
}

double lower_bound(const Match_task& task, const Shared_shape& deformed, const Shared_shape& other,
                   double unmatched_energy)
{
  const double pairs = double(number_of_counted_pairs(*deformed));
  if (task.options.method != Search_method::PARTS)
    return least_energy_of(deformed, other,
                           deformed == task.aligned_source ? task.options.energy : reversed(task.options.energy)) /
           pairs;
  if (task.options.energy.norm == Energy_norm::POOLED) return 0;
  Energy_options energy = task.options.energy;
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

} // namespace

std::vector<Correspondence> least_energy(const Match_task& task)
{
  const Deadline limit = deadline_of(task.options);
  Correspondence known;
  Search_options options = with_role_costs(task, known);
  if (options.coarse_to_fine == 0 &&
      (has_too_many_groups(*task.aligned_source, options.method) ||
       (options.both_directions && has_too_many_groups(*aligned_target(task, 0), options.method))))
    options.coarse_to_fine = automatic_coarse_parts;
  Search_runs searched = runs(task, options, limit);
  if (options.coarse_to_fine == 0 && !searched.best && searched.end.empty()) { // there was too little memory
    options.coarse_to_fine = automatic_coarse_parts;
    searched = runs(task, options, limit);
  }
  std::vector<Correspondence> result;
  if (searched.best)
    result = correspondences_of(task, searched, limit);
  else if (searched.end == search_was_cancelled)
    result.emplace_back();
  else
    return {by_costs(task, searched, limit)};
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

double lower_bound(const Match_task& task, double unmatched_energy)
{
  if (has_no_pairs(task)) return 0;
  const bool both_directions = task.options.both_directions && task.options.method != Search_method::PARTS;
  double bound = std::numeric_limits<double>::infinity();
  for (int turn : tried_turns(task)) {
    const Shared_shape shape = aligned_target(task, turn);
    bound = std::min(bound, lower_bound(task, task.aligned_source, shape, unmatched_energy));
    if (both_directions) bound = std::min(bound, lower_bound(task, shape, task.aligned_source, unmatched_energy));
  }
  constexpr double rounding = 1e-9; // relative and absolute margin, since sums are added up in another order
  return std::max(0., bound * (1 - rounding) - rounding);
}

} // namespace CGAL::Shape_correspondence::internal

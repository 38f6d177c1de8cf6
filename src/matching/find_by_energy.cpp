// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/limits.h"
#include "base/quantized.h"
#include "matching/Correspondence_finder_impl.h"
#include "matching/Search_run.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>
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

// Pairs of connected parts, and parts that touch nothing.
std::size_t number_of_counted_pairs(const Aligned_shape& shape)
{
  std::vector<char> touches(shape.parts.size(), 0);
  for (const Aligned_shape::Contact& contact : shape.contacts)
    touches[contact.parts[0]] = touches[contact.parts[1]] = 1;
  const auto alone = std::size_t(std::count(touches.begin(), touches.end(), 0));
  return std::max<std::size_t>(1, shape.contacts.size() + alone);
}

// Refuses shapes with more groups than `method` can deform.
void check_size(const Aligned_shape& deformed, const std::string& name, const Search_options& options)
{
  const bool is_beam = options.method == Search_method::BEAM;
  const std::size_t most = is_beam ? most_beam_groups : most_exact_groups;
  if (options.coarse_to_fine > 0 || deformed.number_of_groups() <= most) return;
  throw Invalid_input("find_correspondence: shape '" + name + "' has " + std::to_string(deformed.number_of_groups()) +
                      " groups of parts, and " + (is_beam ? "beam" : "exact") + " search takes at most " +
                      std::to_string(most) +
                      " at once: match it coarse to fine, match its largest parts only, or use the default method");
}

} // namespace

Search_options Correspondence_finder::Impl::with_role_costs(const Prepared_shape& target, Correspondence& result) const
{
  Search_options options = options_;
  if (!(options.matching.weights.roles > 0) || !options.roles || options.matching.role_costs.size() > 0) return options;
  Pair_category category;
  const Alignment_candidate alignment = candidates(target, category).front();
  if (const std::optional<Role_votes_of_pair> votes = votes_of(target, category, alignment, result))
    options.matching.role_costs = 1 - agreement_of_votes(*votes->front(), *votes->back()).array();
  return options;
}

std::vector<Correspondence> Correspondence_finder::Impl::least_energy(const Prepared_shape& target) const
{
  check_size(*source_, structure(prepared_source_.graph()).name, options_);
  const std::vector<int> turns = tried_turns(target);
  Correspondence known;
  const Search_options options = with_role_costs(target, known);
  std::vector<Direction> directions{Direction::SOURCE_TO_TARGET};
  if (options_.both_directions) directions.push_back(Direction::TARGET_TO_SOURCE);

  std::unique_ptr<const Search_run> best;
  std::size_t states = 0, evaluations = 0, done = 0;
  const std::size_t run_count = turns.size() * directions.size();
  bool cancelled = false;
  for (std::size_t t = 0; t < turns.size() && !cancelled; ++t) {
    const Shared_shape shape = aligned(target, turns[t]);
    if (options.both_directions) check_size(*shape, structure(target.graph()).name, options);
    for (Direction direction : directions) {
      cancelled = cancelled || (options_.progress && !options_.progress(double(done) / double(run_count)));
      if (cancelled) break;
      auto run = std::make_unique<Search_run>(source_, shape, direction, turns[t], options);
      ++done;
      states += run->result.summary.states;
      evaluations += run->result.summary.evaluations;
      const auto score = [&](const Search_run& of) { return quantized(of.score(options.direction_by_energy)); };
      if (!best || score(*run) < score(*best)) best = std::move(run);
    }
  }

  std::vector<Correspondence> result;
  if (best) {
    std::vector<double> min_marginals;
    if (options_.min_marginals)
      min_marginals = Exact_search(best->problem.energy(), options_.exact).min_marginals(best->result);
    for (const Solution& solution : best->result.solutions)
      result.push_back(correspondence_of(*best, solution, result.empty() ? min_marginals : std::vector<double>()));
  } else {
    result.emplace_back();
  }
  for (Correspondence& correspondence : result) {
    correspondence.search.states = states;
    correspondence.search.evaluations = evaluations;
    take_roles(known, correspondence);
    if (cancelled) mark_cancelled(done, run_count, correspondence);
  }
  return result;
}

double Correspondence_finder::Impl::lower_bound(const Prepared_shape& target, double unmatched_energy) const
{
  const bool both_directions = options_.both_directions && options_.method != Search_method::PARTS;
  double bound = std::numeric_limits<double>::infinity();
  for (int turn : tried_turns(target)) {
    const Shared_shape shape = aligned(target, turn);
    bound = std::min(bound, lower_bound(source_, shape, unmatched_energy));
    if (both_directions) bound = std::min(bound, lower_bound(shape, source_, unmatched_energy));
  }
  constexpr double rounding = 1e-9; // sums are added up in another order
  return std::max(0., bound * (1 - rounding) - rounding);
}

double Correspondence_finder::Impl::lower_bound(const Shared_shape& deformed, const Shared_shape& other,
                                                double unmatched_energy) const
{
  const double pairs = double(number_of_counted_pairs(*deformed));
  if (options_.method != Search_method::PARTS)
    return Matching_problem(deformed, other, deformed == source_ ? options_.matching : reversed(options_.matching))
               .energy()
               .lower_bound() /
           pairs;
  if (options_.matching.norm == Energy_norm::POOLED) return 0;
  Matching_options matching = options_.matching;
  matching.cut_curves = false;
  matching.pinned.clear(); // without them the energy is not greater
  matching.forbidden.clear();
  matching.role_costs.resize(0, 0);
  matching.unmatched_cost = unmatched_energy;
  const Matching_problem problem(std::make_shared<Deformable_shape>(deformed->ungrouped()),
                                 std::make_shared<Deformable_shape>(other->ungrouped()), matching);
  return problem.has_shortlists() ? 0 : problem.energy().lower_bound() / pairs;
}

} // namespace CGAL::Shape_correspondence

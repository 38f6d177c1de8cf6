// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "matching/Search_run.h"
#include "matching/coarse_to_fine.h"
#include "search/beam_search.h"

#include <CGAL/Shape_correspondence/exact_search.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>

namespace CGAL::Shape_correspondence::internal {

namespace {

Matching_options without_cost_of_unmatched(Matching_options options)
{
  options.unmatched_cost = 0;
  return options;
}

Search_options backward(Search_options options)
{
  options.matching = reversed(std::move(options.matching));
  return options;
}

Matching_problem problem_of(const Matching_problem::Shared_shape& source, const Matching_problem::Shared_shape& target,
                            const Search_options& options, const Deadline& deadline)
{
  return {source, target, options.matching, coarse_candidates(source, target, options, deadline), deadline};
}

// \throw Too_large if there is no memory for exact search, which holds four tables of the size of the energy's
void check_exact_tables(const Pairwise_energy& energy)
{
  double values = 0;
  for (const Pairwise_energy::Edge& edge : energy.edges)
    values += double(edge.cost.size());
  check_bytes_of_tables(4 * sizeof(double) * values);
}

std::vector<std::size_t> original_parts(const Aligned_shape& shape, const std::vector<std::size_t>& parts)
{
  std::vector<std::size_t> result;
  for (std::size_t part : parts)
    result.push_back(shape.original[part]);
  std::sort(result.begin(), result.end());
  return result;
}

// Gives every contact its energy, and half of it to each of its two groups.
std::vector<Rod_energy> share_energy(const Matching_problem& problem, const Assignment& assignment,
                                     Correspondence& correspondence)
{
  const Aligned_shape& shape = problem.source();
  std::vector<Rod_energy> group_energy;
  for (std::size_t g = 0; g < shape.number_of_groups(); ++g) {
    const Energy_terms& cuts = problem.group_terms(g, std::size_t(assignment[g]));
    group_energy.push_back({cuts.distortion, cuts.connectedness});
  }
  for (std::size_t contact = 0; contact < shape.contacts.size(); ++contact) {
    const auto& parts = shape.contacts[contact].parts;
    const Rod_energy energy = problem.contact_energy(contact, assignment);
    for (std::size_t group : problem.groups_of_contact(contact)) {
      group_energy[group].distortion += energy.distortion / 2;
      group_energy[group].connectedness += energy.connectedness / 2;
    }
    Contact_energy report{
        {shape.original[parts[0]], shape.original[parts[1]]}, energy.distortion, energy.connectedness};
    std::sort(report.parts.begin(), report.parts.end());
    correspondence.contacts.push_back(report);
  }
  std::sort(correspondence.contacts.begin(), correspondence.contacts.end(),
            [](const Contact_energy& a, const Contact_energy& b) { return a.parts < b.parts; });
  return group_energy;
}

Curve_segment segment_of(const Piece& piece) { return {short(piece.index), short(piece.count)}; }

// Adds the pairs of a label: each part of the deformed shape with its images.
void collect_pairs(const Group_label& label, const Aligned_shape& shape, const Aligned_shape& other,
                   Correspondence& correspondence)
{
  for (const auto& images : label.images)
    for (const Piece_image& image : images) {
      Part_correspondence pair{shape.original[image.source.part], other.original[image.target.part]};
      pair.source_segment = segment_of(image.source);
      pair.target_segment = segment_of(image.target);
      correspondence.pairs.push_back(correspondence.direction == Direction::SOURCE_TO_TARGET ? pair : inverse(pair));
    }
}

void collect_groups(const Matching_problem& problem, const Assignment& assignment,
                    const std::vector<double>& min_marginals, Correspondence& correspondence)
{
  const Aligned_shape &shape = problem.source(), &other = problem.target();
  const Energy_weights& weights = problem.options().weights;
  const bool forward = correspondence.direction == Direction::SOURCE_TO_TARGET;
  const std::vector<Rod_energy> group_energy = share_energy(problem, assignment, correspondence);
  for (std::size_t g = 0; g < shape.number_of_groups(); ++g) {
    const Group_label& label = problem.label(g, std::size_t(assignment[g]));
    Group_match match;
    match.source = original_parts(shape, shape.group(g).parts);
    match.target = original_parts(other, image_parts(label));
    match.operation = label.operation;
    match.distortion = group_energy[g].distortion;
    match.connectedness = group_energy[g].connectedness;
    match.energy = weights.distortion * match.distortion + weights.connectedness * match.connectedness;
    match.solidity_ratio = label.solidity_ratio;
    if (!min_marginals.empty()) match.min_marginal = min_marginals[g];
    collect_pairs(label, shape, other, correspondence);
    if (!forward) std::swap(match.source, match.target);
    correspondence.groups.push_back(std::move(match));
  }
  const auto deformed_parts = [&](const Group_match& match) { return forward ? match.source : match.target; };
  std::sort(correspondence.groups.begin(), correspondence.groups.end(),
            [&](const Group_match& a, const Group_match& b) { return deformed_parts(a) < deformed_parts(b); });
  std::sort(correspondence.pairs.begin(), correspondence.pairs.end(), is_before);
}

// Whether a label breaks the paper's rule that a group becomes a group or a self-symmetric part.
bool merges_into_asymmetric_part(const Search_run& run, const Assignment& assignment)
{
  if (run.result.summary.method == "parts") return false;
  const Matching_problem& problem = run.problem;
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

} // namespace

Search_run::Search_run(const Shared_shape& source, const Shared_shape& target, Direction direction, int turns,
                       const Search_options& options, const Deadline& deadline)
    : problem(direction == Direction::SOURCE_TO_TARGET ? problem_of(source, target, options, deadline)
                                                       : problem_of(target, source, backward(options), deadline)),
      direction(direction),
      turns(turns),
      coarse_parts(is_coarse_to_fine(*source, *target, options) ? std::size_t(options.coarse_to_fine) : 0)
{
  if (options.method == Search_method::EXACT) {
    check_exact_tables(problem.energy());
    deadline.check();
    Exact_options exact = until(deadline, options.exact);
    exact.solutions = std::size_t(options.solutions);
    result = exact_search(problem.energy(), exact);
  } else {
    result = beam_search(problem, options.beam, deadline);
  }
  if (result.solutions.size() > std::size_t(options.solutions)) result.solutions.resize(std::size_t(options.solutions));
  result.optimal = result.optimal && !problem.has_shortlists();
}

Search_run::Search_run(const Shared_shape& source, const Shared_shape& target, int turns,
                       std::vector<std::vector<Group_label>> labels, const Search_options& options,
                       const Deadline& deadline)
    : problem(source, target, std::move(labels), without_cost_of_unmatched(options.matching), deadline),
      direction(Direction::SOURCE_TO_TARGET),
      turns(turns)
{
  const Assignment assignment(source->number_of_groups(), 0);
  result.solutions = {{problem.energy()(assignment), assignment}};
  result.summary.method = "parts";
  result.summary.states = result.summary.evaluations = 1;
}

double Search_run::score(bool by_energy) const
{
  if (by_energy) return result.best().energy;
  return result.best().energy / double(std::max<std::size_t>(1, problem.source().contacts.size()));
}

Exact_options until(const Deadline& deadline, Exact_options options)
{
  const double left = deadline.left();
  if (left < Deadline::never && (options.time_limit == 0 || left < options.time_limit)) options.time_limit = left;
  return options;
}

std::vector<std::size_t> image_parts(const Group_label& label)
{
  std::set<std::size_t> parts;
  for (const auto& images : label.images)
    for (const Piece_image& image : images)
      parts.insert(image.target.part);
  return {parts.begin(), parts.end()};
}

void collect_unmatched(std::size_t source_parts, std::size_t target_parts, Correspondence& correspondence)
{
  std::vector<char> source(source_parts, 0), target(target_parts, 0);
  for (const Part_correspondence& pair : correspondence.pairs)
    source[pair.source] = 1, target[pair.target] = 1;
  const auto zeros = [](const std::vector<char>& is_matched) {
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < is_matched.size(); ++i)
      if (!is_matched[i]) result.push_back(i);
    return result;
  };
  correspondence.unmatched_source = zeros(source);
  correspondence.unmatched_target = zeros(target);
}

Correspondence correspondence_of(const Search_run& run, const Solution& solution,
                                 const std::vector<double>& min_marginals)
{
  Correspondence correspondence;
  correspondence.direction = run.direction;
  correspondence.target_quarter_turns = run.turns;
  correspondence.energy = solution.energy;
  correspondence.terms = run.problem.terms(solution.assignment);
  correspondence.complete = true;
  correspondence.optimal = run.result.optimal;
  correspondence.search = run.result.summary;
  if (run.coarse_parts > 0)
    correspondence.warnings.push_back("The " + std::to_string(run.coarse_parts) +
                                      " largest parts were matched first; the others were matched about them.");
  else if (run.problem.has_shortlists())
    correspondence.warnings.push_back("There are " + std::to_string(run.problem.target().number_of_groups()) +
                                      " groups to choose from; each was given the " + std::to_string(maximum_labels) +
                                      " nearest in place and size to choose from.");
  if (merges_into_asymmetric_part(run, solution.assignment))
    correspondence.warnings.push_back(
        "A group of parts was merged into one part that is not symmetric by itself: there "
        "is neither a group nor a symmetric part that it could have become.");
  collect_groups(run.problem, solution.assignment, min_marginals, correspondence);
  return correspondence;
}

} // namespace CGAL::Shape_correspondence::internal

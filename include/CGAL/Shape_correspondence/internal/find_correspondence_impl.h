// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_INTERNAL_FIND_CORRESPONDENCE_IMPL_H
#define CGAL_SHAPE_CORRESPONDENCE_INTERNAL_FIND_CORRESPONDENCE_IMPL_H

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>
#include <CGAL/Shape_correspondence/internal/quantized.h>

#include <algorithm>
#include <limits>
#include <string>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

// One run of the search: `deformed` is the shape that plays the paper's source.
struct Search_run
{
  Matching_problem problem;
  Search_result result;

  Search_run(const Aligned_shape& deformed, const Aligned_shape& other, const Search_options& options)
      : problem(deformed, other, options.weights, options.maximum_parts),
        result(options.method == Search_method::EXACT ? exact_search(problem, options.exact)
                                                      : beam_search(problem, options.beam))
  {}

  // Energy per pair of connected parts, which compares between directions
  double score() const { return result.energy / double(std::max<std::size_t>(1, problem.active_contacts().size())); }
};

inline std::vector<std::size_t> original_parts(const Aligned_shape& shape, const std::vector<std::size_t>& parts)
{
  std::vector<std::size_t> result;
  for (std::size_t part : parts)
    result.push_back(shape.original[part]);
  std::sort(result.begin(), result.end());
  return result;
}

// Half of every contact's cost to either of its groups.
inline void share_energy(const Search_run& run, std::vector<Rod_energy>& group_energy, Correspondence& correspondence)
{
  const Matching_problem& problem = run.problem;
  const Aligned_shape& shape = problem.source();
  for (std::size_t contact : problem.active_contacts()) {
    const auto& parts = shape.contacts[contact].parts;
    const std::size_t g = shape.group_of[parts[0]], h = shape.group_of[parts[1]];
    const Rod_energy energy =
        problem.contact_energy(contact, std::size_t(run.result.assignment[g]), std::size_t(run.result.assignment[h]));
    for (std::size_t group : {g, h}) {
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
}

inline void collect_groups(const Search_run& run, Correspondence& correspondence)
{
  const Matching_problem& problem = run.problem;
  const Aligned_shape &shape = problem.source(), &other = problem.target();
  const bool forward = correspondence.direction == Direction::SOURCE_TO_TARGET;
  std::vector<Rod_energy> group_energy(shape.groups.size());
  share_energy(run, group_energy, correspondence);
  for (std::size_t g : problem.active_groups()) {
    const Group_label& label = problem.label(g, std::size_t(run.result.assignment[g]));
    Group_match match;
    match.source = original_parts(shape, shape.groups[g].parts);
    match.target = original_parts(other, other.groups[label.target_group].parts);
    match.operation = label.operation;
    match.distortion = group_energy[g].distortion;
    match.connectedness = group_energy[g].connectedness;
    match.energy = match.distortion + problem.weights().connectedness * match.connectedness;
    match.solidity_ratio = label.solidity_ratio;
    for (std::size_t i = 0; i < label.images.size(); ++i)
      for (std::size_t image : label.images[i]) {
        const std::size_t part = shape.original[shape.groups[g].parts[i]], became = other.original[image];
        correspondence.pairs.push_back(forward ? std::make_pair(part, became) : std::make_pair(became, part));
      }
    if (!forward) std::swap(match.source, match.target);
    correspondence.groups.push_back(std::move(match));
  }
  const auto deformed_parts = [&](const Group_match& match) { return forward ? match.source : match.target; };
  std::sort(correspondence.groups.begin(), correspondence.groups.end(),
            [&](const Group_match& a, const Group_match& b) { return deformed_parts(a) < deformed_parts(b); });
  std::sort(correspondence.pairs.begin(), correspondence.pairs.end());
}

inline std::vector<std::size_t> unmatched(const std::vector<char>& is_matched)
{
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < is_matched.size(); ++i)
    if (!is_matched[i]) result.push_back(i);
  return result;
}

inline Correspondence correspondence_of(const Search_run& run, Direction direction, std::size_t source_parts,
                                        std::size_t target_parts)
{
  Correspondence correspondence;
  correspondence.direction = direction;
  correspondence.energy = run.result.energy;
  correspondence.terms = run.problem.terms(run.result.assignment);
  correspondence.complete = true;
  correspondence.optimal = run.result.optimal;
  correspondence.search = run.result.summary;
  if (run.problem.has_shortlists())
    correspondence.warnings.push_back("There are " + std::to_string(run.problem.target().groups.size()) +
                                      " groups to choose from; each was given the " + std::to_string(maximum_labels) +
                                      " nearest in place and size to choose from.");
  collect_groups(run, correspondence);

  std::vector<char> source(source_parts, 0), target(target_parts, 0);
  for (const auto& pair : correspondence.pairs)
    source[pair.first] = 1, target[pair.second] = 1;
  correspondence.unmatched_source = unmatched(source);
  correspondence.unmatched_target = unmatched(target);
  return correspondence;
}

} // namespace internal

CGAL_SHAPE_CORRESPONDENCE_INLINE Correspondence find_correspondence(const Structural_graph& source,
                                                                    const Structural_graph& target,
                                                                    const Search_options& options)
{
  if (options.weights.connectedness < 0 || options.weights.split < 0)
    throw Invalid_input("find_correspondence: the weights w_c and w_s must not be negative");
  if (options.maximum_parts < 0 || options.alignments < 0)
    throw Invalid_input("find_correspondence: the numbers of parts and of alignments must not be negative");

  std::vector<int> turns = alignment_turns(structure(source).frame, structure(target).frame);
  if (options.alignments > 0 && turns.size() > std::size_t(options.alignments))
    turns.resize(std::size_t(options.alignments));

  const Aligned_shape from = align_shape(source);
  Correspondence best;
  long best_score = std::numeric_limits<long>::max();
  std::size_t states = 0, evaluations = 0;
  for (int turn : turns) {
    const Aligned_shape to = align_shape(target, turn);
    for (Direction direction : {Direction::SOURCE_TO_TARGET, Direction::TARGET_TO_SOURCE}) {
      const bool forward = direction == Direction::SOURCE_TO_TARGET;
      if (!forward && !options.both_directions) continue;
      const internal::Search_run run(forward ? from : to, forward ? to : from, options);
      states += run.result.summary.states;
      evaluations += run.result.summary.evaluations;
      const long score = internal::quantized(run.score());
      if (score >= best_score) continue;
      best_score = score;
      best = internal::correspondence_of(run, direction, from.parts.size(), to.parts.size());
      best.target_quarter_turns = turn;
    }
  }
  best.search.states = states;
  best.search.evaluations = evaluations;
  return best;
}

} // namespace Shape_correspondence
} // namespace CGAL

#endif

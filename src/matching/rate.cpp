// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "matching/rate.h"

#include <algorithm>
#include <utility>

namespace CGAL::Shape_correspondence::internal {

namespace {

std::vector<std::size_t> original_parts(const Aligned_shape& shape, const std::vector<std::size_t>& parts)
{
  std::vector<std::size_t> result;
  for (std::size_t part : parts)
    result.push_back(shape.original[part]);
  std::sort(result.begin(), result.end());
  return result;
}

// Lists the energy of every contact, and shares it between its two groups. \return the share of each group, plus
// the energy between the segments of its cut parts
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

} // namespace

Correspondence rate(const Matching_problem& problem, const Assignment& assignment, Direction direction, int turns,
                    const std::vector<double>& min_marginals)
{
  Correspondence correspondence;
  correspondence.direction = direction;
  correspondence.target_quarter_turns = turns;
  correspondence.energy = problem.energy()(assignment);
  correspondence.terms = problem.terms(assignment);
  correspondence.complete = true;
  collect_groups(problem, assignment, min_marginals, correspondence);
  return correspondence;
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

} // namespace CGAL::Shape_correspondence::internal

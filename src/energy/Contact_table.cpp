// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "energy/Contact_table.h"

#include <utility>

namespace CGAL::Shape_correspondence {

Matching_problem::Contact_table::Contact_table(const Matching_problem& problem)
    : problem_(problem), fitted_(problem.fitted_), pair_of_(fitted_.number_of_lanes() * fitted_.number_of_lanes(), none)
{}

void Matching_problem::Contact_table::list(std::size_t contact)
{
  contact_ = contact;
  const auto& parts = problem_.source().contacts[contact].parts;
  const bool same_group = problem_.source().group_of[parts[0]] == problem_.source().group_of[parts[1]];
  for (int side : {0, 1}) {
    const std::size_t part = parts[std::size_t(side)];
    begin_[side] = fitted_.begin_of(part);
    count_[side] = fitted_.begin_of(part + 1) - begin_[side];
    touching_[side].clear();
    for (std::size_t label = 0; label < problem_.number_of_labels(problem_.source().group_of[part]); ++label)
      touching_[side].push_back(problem_.touching(contact, side, label));
  }
  known_.assign(count_[0] * count_[1], none);
  first_piece_rods_ = piece_rods_.size();
  for (std::size_t a = 0; a < touching_[0].size(); ++a)
    for (std::size_t b = 0; b < touching_[1].size(); ++b) {
      const std::size_t before = compared_.size();
      if (!same_group || a == b) list(touching_[0][a], touching_[1][b]);
      counts_.push_back(std::uint32_t(compared_.size() - before));
    }
}

void Matching_problem::Contact_table::compute(std::vector<Rod_energy>& result)
{
  compare();
  auto compared = compared_.begin();
  for (const std::uint32_t count : counts_) {
    Rod_energy sum;
    for (std::uint32_t i = 0; i < count; ++i, ++compared) {
      sum.distortion += comparisons_[*compared].energy.distortion;
      sum.connectedness += comparisons_[*compared].energy.connectedness;
    }
    if (count > 1) sum = {sum.distortion / double(count), sum.connectedness / double(count)};
    result.push_back(sum);
  }
  comparisons_.clear();
  counts_.clear();
  compared_.clear();
  piece_rods_.clear();
}

void Matching_problem::Contact_table::list(const Range& first, const Range& second)
{
  if (first.size() == 1 || second.size() == 1) {
    for (std::uint32_t a : first)
      for (std::uint32_t b : second)
        compared_.push_back(comparison(a, b));
    return;
  }
  if (first.empty() || second.empty()) return;
  for (std::uint32_t a : first)
    compared_.push_back(comparison(a, nearest(a, second)));
  for (std::uint32_t b : second) {
    const std::uint32_t a = nearest(b, first);
    if (nearest(a, second) != b) compared_.push_back(comparison(a, b));
  }
}

std::uint32_t Matching_problem::Contact_table::nearest(std::uint32_t fitted, const Range& others) const
{
  const auto distance = [&](std::size_t other) { return fitted_.target_distance(fitted_[other], fitted_[fitted]); };
  std::uint32_t best = *others.first;
  double least = distance(best);
  for (const std::uint32_t* other = others.first + 1; other != others.last; ++other) {
    const double d = distance(*other);
    if (d < least) least = d, best = *other;
  }
  return best;
}

std::uint32_t Matching_problem::Contact_table::comparison(std::uint32_t a, std::uint32_t b)
{
  std::uint32_t& known = known_[(a - begin_[0]) * count_[1] + b - begin_[1]];
  if (known != none) return known;
  known = std::uint32_t(comparisons_.size());
  const Fitted &first = fitted_[a], &second = fitted_[b];
  std::uint32_t& pair = pair_of_[pair_index(first, second)];
  if (pair == none) {
    pair = std::uint32_t(pairs_.size());
    pairs_.push_back({a, b, none});
  }
  comparisons_.emplace_back(); // and filled there: the copy of a new one would stall on its parts just written
  comparisons_.back().rods = &rods(first, second);
  comparisons_.back().next = std::exchange(pairs_[pair].comparison, known);
  return known;
}

std::size_t Matching_problem::Contact_table::pair_index(const Fitted& first, const Fitted& second) const
{
  return first.lanes * fitted_.number_of_lanes() + second.lanes;
}

void Matching_problem::Contact_table::compare()
{
  for (const Target_pair& pair : pairs_) {
    const Fitted &first = fitted_[pair.first], &second = fitted_[pair.second];
    rods_.clear();
    for (std::uint32_t i = pair.comparison; i != none; i = comparisons_[i].next)
      rods_.push_back(comparisons_[i].rods);
    distortions(rods_, fitted_.samples(first), fitted_.samples(second), distortions_);
    auto distortion = distortions_.begin();
    for (std::uint32_t i = pair.comparison; i != none; i = comparisons_[i].next)
      comparisons_[i].energy = {*distortion++, fitted_.connectedness(*comparisons_[i].rods, first, second)};
    pair_of_[pair_index(first, second)] = none;
  }
  pairs_.clear();
}

const Structural_rods& Matching_problem::Contact_table::rods(const Fitted& first, const Fitted& second)
{
  if (first.source.is_whole() && second.source.is_whole()) return problem_.rods(contact_, first.lifted, second.lifted);
  const Eigen::Index n = Eigen::Index(first.order->size()), m = Eigen::Index(second.order->size());
  for (std::size_t i = first_piece_rods_; i < piece_rods_.size(); ++i) {
    const Piece_rods& known = piece_rods_[i];
    if (known.first == first.source_index && known.second == second.source_index && known.counts[0] == n &&
        known.counts[1] == m)
      return known.rods;
  }
  piece_rods_.push_back({first.source_index,
                         second.source_index,
                         {n, m},
                         Structural_rods(lifted_samples(fitted_.source_piece(first.source_index), n),
                                         lifted_samples(fitted_.source_piece(second.source_index), m))});
  return piece_rods_.back().rods;
}

} // namespace CGAL::Shape_correspondence

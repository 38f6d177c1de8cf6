// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "energy/Contact_table.h"

#include <algorithm>
#include <utility>

namespace CGAL::Shape_correspondence {
using namespace internal;

Matching_problem::Contact_table::Contact_table(const Matching_problem& problem)
    : problem_(problem),
      fitted_(problem.fitted_),
      pair_of_(fitted_.takes_samples() ? fitted_.number_of_lanes() * fitted_.number_of_lanes() : 0, none),
      distances_(fitted_.number_of_target_pieces())
{}

void Matching_problem::Contact_table::list(std::size_t contact)
{
  contact_ = contact;
  const std::array<std::size_t, 2> groups = problem_.groups_of_contact(contact);
  for (std::size_t side : {0, 1}) {
    const std::size_t part = problem_.source().contacts[contact].parts[side];
    begin_[side] = fitted_.begin_of(part);
    count_[side] = fitted_.begin_of(part + 1) - begin_[side];
    touching_[side].clear();
    for (std::size_t label = 0; label < problem_.number_of_labels(groups[side]); ++label)
      touching_[side].push_back(problem_.touching(contact, side, label));
  }
  known_.assign(count_[0] * count_[1], none);
  for (std::size_t a = 0; a < touching_[0].size(); ++a)
    for (std::size_t b = 0; b < touching_[1].size(); ++b) {
      const std::size_t before = compared_.size();
      if (groups[0] != groups[1] || a == b) list(touching_[0][a], touching_[1][b]);
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
  used_bytes_ = 0;
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
  nearest_.clear();
  for (std::uint32_t a : first) {
    nearest_.push_back(*nearest(a, second));
    compared_.push_back(comparison(a, nearest_.back()));
  }
  for (std::uint32_t b : second) {
    const std::uint32_t* a = nearest(b, first);
    if (nearest_[std::size_t(a - first.begin())] != b) compared_.push_back(comparison(*a, b));
  }
}

const std::uint32_t* Matching_problem::Contact_table::nearest(std::uint32_t fitted, const Range& others)
{
  const std::uint32_t* best = others.begin();
  double least = distance(fitted_[fitted], fitted_[*best]);
  for (const std::uint32_t* other = best + 1; other != others.end(); ++other) {
    const double other_distance = distance(fitted_[fitted], fitted_[*other]);
    if (other_distance < least) least = other_distance, best = other;
  }
  return best;
}

double Matching_problem::Contact_table::distance(const Fitted& first, const Fitted& second)
{
  const bool is_cached = fitted_.takes_samples() && !(first.target.is_whole() && second.target.is_whole());
  if (!is_cached) return fitted_.distance(first, second);
  const auto [low, high] = std::minmax(first.target_index, second.target_index);
  std::vector<double>& known = distances_[high];
  if (known.empty()) known.assign(high + 1, -1);
  if (known[low] < 0) known[low] = fitted_.distance(first, second);
  return known[low];
}

std::uint32_t Matching_problem::Contact_table::comparison(std::uint32_t a, std::uint32_t b)
{
  std::uint32_t& known = known_[(a - begin_[0]) * count_[1] + b - begin_[1]];
  if (known != none) return known;
  known = std::uint32_t(comparisons_.size());
  const Fitted &first = fitted_[a], &second = fitted_[b];
  std::uint32_t own_pair = none;
  std::uint32_t& pair = pair_of_.empty() ? own_pair : pair_of_[pair_index(first, second)];
  if (pair == none) {
    pair = std::uint32_t(pairs_.size());
    pairs_.push_back({a, b, none});
  }
  comparisons_.emplace_back(); // filled in place: a copy would wait for the stores of its members
  comparisons_.back().rods = &rods(a, b);
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
    const bool collapsed = overlap(first.target, second.target);
    const double least = collapsed ? 0 : distance(first, second);
    auto distortion = distortions_.begin();
    for (std::uint32_t i = pair.comparison; i != none; i = comparisons_[i].next)
      comparisons_[i].energy = {*distortion++,
                                collapsed ? collapsed_connectedness : comparisons_[i].rods->connectedness(least)};
    if (!pair_of_.empty()) pair_of_[pair_index(first, second)] = none;
  }
  pairs_.clear();
}

const Structural_rods& Matching_problem::Contact_table::rods(std::uint32_t a, std::uint32_t b)
{
  const Fitted &first = fitted_[a], &second = fitted_[b];
  if (first.source.is_whole() && second.source.is_whole())
    return problem_.source().rods(contact_, first.repeats, second.repeats);
  const auto [known, is_new] =
      piece_rods_.try_emplace({first.source_lanes, second.source_lanes}, fitted_.source_samples(first), first.samples,
                              fitted_.source_samples(second), second.samples);
  if (is_new) used_bytes_ += known->second.bytes();
  return known->second;
}

} // namespace CGAL::Shape_correspondence

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
    list_ends(side);
  }
  known_.assign(count_[0] * count_[1], none);
  rods_of_ends_.assign(ends_[0].size() * ends_[1].size(), nullptr);
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
  piece_memory_.clear();
  used_blocks_ = 0;
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

void Matching_problem::Contact_table::list_ends(std::size_t side)
{
  ends_[side].clear();
  end_of_[side].clear();
  for (std::size_t i = begin_[side]; i < begin_[side] + count_[side]; ++i) {
    const std::size_t end = fitted_[i].source_lanes;
    const auto known = std::find(ends_[side].begin(), ends_[side].end(), end);
    end_of_[side].push_back(std::size_t(known - ends_[side].begin()));
    if (known == ends_[side].end()) ends_[side].push_back(end);
  }
}

const Structural_rods& Matching_problem::Contact_table::rods(std::uint32_t a, std::uint32_t b)
{
  const std::size_t i = end_of_[0][a - begin_[0]], j = end_of_[1][b - begin_[1]];
  const Structural_rods*& known = rods_of_ends_[i * ends_[1].size() + j];
  if (known) return *known;
  const Fitted &first = fitted_[a], &second = fitted_[b];
  if (first.source.is_whole() && second.source.is_whole()) {
    known = &problem_.source().rods(contact_, first.repeats, second.repeats);
    return *known;
  }
  const std::size_t blocks = Structural_rods::size(first.samples, second.samples);
  used_blocks_ += blocks;
  piece_rods_.emplace_back(fitted_.source_samples(first), first.samples, fitted_.source_samples(second), second.samples,
                           piece_memory_.take(blocks));
  known = &piece_rods_.back();
  return *known;
}

} // namespace CGAL::Shape_correspondence

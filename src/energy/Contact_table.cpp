// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "energy/Matching_problem.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence {
using namespace internal;

namespace {

// Computes the energies of all contacts by the labels of their two parts. Comparisons of rods are listed first, so that
// the rods of a pair of deformed pieces are found once, for all contacts that may turn into it. With
// `Deform_to_fit::SAMPLES` a deformed piece has the samples of a target piece, which many contacts share; with
// `EXTREMITIES` every source piece has deformed samples of its own.
class Contact_table
{
public:
  Contact_table(const Matching_problem& problem, const Deadline& deadline)
      : problem_(problem),
        fitted_(problem.fitted()),
        deadline_(deadline),
        pair_of_(number_of_lane_pairs(), none),
        distances_(fitted_.number_of_target_pieces())
  {}

  // Lists, for all labels of the next contact's parts, the pairs of pieces whose energies are averaged to its energy.
  void list(std::size_t contact)
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
    for (std::size_t a = 0; a < touching_[0].size(); ++a) {
      deadline_.check();
      for (std::size_t b = 0; b < touching_[1].size(); ++b) {
        const std::size_t before = compared_.size();
        if (groups[0] != groups[1] || a == b) list(touching_[0][a], touching_[1][b]);
        counts_.push_back(std::uint32_t(compared_.size() - before));
      }
    }
  }

  // Whether the listed comparisons and their rods exceed what the processor's cache can keep.
  bool is_full() const { return comparisons_.size() > maximum_comparisons || used_bytes_ > maximum_bytes; }

  // Appends the energies of the listed contacts, contact by contact, by first, then second label; clears the list.
  void compute(std::vector<Rod_energy>& result)
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

private:
  using Range = Fitted_range;
  using Fitted = Fitted_piece;

  static constexpr std::uint32_t none = std::uint32_t(-1);
  // Limits of the lists: number of comparisons, and memory of `piece_rods_` in bytes
  static constexpr std::size_t maximum_comparisons = 8192, maximum_bytes = 3u << 17;

  // The rods between two source pieces, and their energy after the deformation into the target pair that lists them.
  struct Comparison
  {
    const Structural_rods* rods;
    std::uint32_t next; // index of the next comparison of the target pair, or `none`
    Rod_energy energy;
  };

  // Two deformed pieces, each represented by one of the fitted pieces that share its samples.
  struct Target_pair
  {
    std::uint32_t first, second; // indices of fitted pieces
    std::uint32_t comparison;    // index of its first comparison; `Comparison::next` gives the next one
  };

  std::size_t number_of_lane_pairs() const
  {
    const std::size_t lanes = fitted_.takes_samples() ? fitted_.number_of_lanes() : 0;
    check_bytes_of_tables(double(sizeof(std::uint32_t)) * double(lanes) * double(lanes));
    return lanes * lanes;
  }

  // Lists, for each clone of either part, its pair with the nearest clone of the other part.
  void list(const Range& first, const Range& second)
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

  const std::uint32_t* nearest(std::uint32_t fitted, const Range& others)
  {
    const std::uint32_t* best = others.begin();
    double least = distance(fitted_[fitted], fitted_[*best]);
    for (const std::uint32_t* other = best + 1; other != others.end(); ++other) {
      const double other_distance = distance(fitted_[fitted], fitted_[*other]);
      if (other_distance < least) least = other_distance, best = other;
    }
    return best;
  }

  double distance(const Fitted& first, const Fitted& second)
  {
    const bool is_cached = fitted_.takes_samples() && !(first.target.is_whole() && second.target.is_whole());
    if (!is_cached) return fitted_.distance(first, second);
    const auto [low, high] = std::minmax(first.target_index, second.target_index);
    std::vector<double>& known = distances_[high];
    if (known.empty()) known.assign(high + 1, -1);
    if (known[low] < 0) known[low] = fitted_.distance(first, second);
    return known[low];
  }

  std::uint32_t comparison(std::uint32_t a, std::uint32_t b)
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
    comparisons_.emplace_back(); // constructed in place: copying it would stall on the stores to its members
    comparisons_.back().rods = &rods(a, b);
    comparisons_.back().next = std::exchange(pairs_[pair].comparison, known);
    return known;
  }

  std::size_t pair_index(const Fitted& first, const Fitted& second) const
  {
    return first.lanes * fitted_.number_of_lanes() + second.lanes;
  }

  void compare()
  {
    for (const Target_pair& pair : pairs_) {
      deadline_.check();
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

  const Structural_rods& rods(std::uint32_t a, std::uint32_t b)
  {
    const Fitted &first = fitted_[a], &second = fitted_[b];
    if (first.source.is_whole() && second.source.is_whole())
      return problem_.source().rods(contact_, first.repeats, second.repeats);
    const std::array<std::size_t, 4> pieces{first.source_index, std::size_t(first.repeats), second.source_index,
                                            std::size_t(second.repeats)};
    const auto [known, is_new] = piece_rods_.try_emplace(pieces);
    if (is_new)
      known->second = Structural_rods(fitted_.source_piece(first.source_index).samples,
                                      fitted_.source_piece(second.source_index).samples, first.repeats, second.repeats);
    if (is_new) used_bytes_ += known->second.bytes();
    return known->second;
  }

  const Matching_problem& problem_;
  const Fitted_pieces& fitted_;
  const Deadline& deadline_;
  std::vector<std::uint32_t> pair_of_;  // index in `pairs_` by `pair_index()`; empty if fitted pieces share no samples
  std::vector<Target_pair> pairs_;      // the pairs that have comparisons
  std::vector<Comparison> comparisons_; // ordered by contact
  std::vector<std::uint32_t> counts_;   // number of comparisons of each contact, by the labels of its two parts
  std::vector<std::uint32_t> compared_; // indices of the comparisons, in the order of `counts_`
  // Rods by two source pieces, at least one of which is not a whole part, and their repeats
  std::map<std::array<std::size_t, 4>, Structural_rods> piece_rods_;
  std::size_t used_bytes_ = 0;                 // memory of `piece_rods_`, in bytes
  std::vector<std::vector<double>> distances_; // least distance by target pieces; negative: not computed yet

  // The contact that is being listed, and the fitted pieces of its two sides
  std::size_t contact_ = 0;
  std::array<std::size_t, 2> begin_, count_;   // range of the fitted pieces of either part
  std::array<std::vector<Range>, 2> touching_; // fitted pieces at the contact, by side and label
  std::vector<std::uint32_t> known_;           // index of the comparison of two fitted pieces, or `none`

  // Buffers, kept between calls so that they are allocated once
  std::vector<const Structural_rods*> rods_;
  std::vector<double> distortions_;
  std::vector<std::uint32_t> nearest_;
};

} // namespace

void check_bytes_of_tables(double bytes)
{
  if (bytes <= double(most_bytes_of_tables)) return;
  constexpr double gigabyte = 1 << 30;
  throw Too_large("take " + std::to_string(std::lround(std::ceil(bytes / gigabyte))) + " GB of memory");
}

void Matching_problem::fill_contact_energies(const Deadline& deadline)
{
  std::size_t count = 0;
  for (std::size_t contact = 0; contact < source().contacts.size(); ++contact) {
    const auto [first, second] = groups_of_contact(contact);
    contact_begin_.push_back(count);
    count += number_of_labels(first) * number_of_labels(second);
  }
  contact_energies_.reserve(count);
  Contact_table table(*this, deadline);
  for (std::size_t contact = 0; contact < source().contacts.size(); ++contact) {
    table.list(contact);
    if (table.is_full()) table.compute(contact_energies_);
  }
  table.compute(contact_energies_);
}

} // namespace CGAL::Shape_correspondence

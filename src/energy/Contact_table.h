// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "energy/Matching_problem.h"
#include "energy/Rod_memory.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

namespace CGAL::Shape_correspondence {

// Computes the energies of all contacts by the labels of their two parts. What is to be compared is listed first, so
// that the rods of a pair of target pieces are found once, for all contacts that may turn into it.
class Matching_problem::Contact_table
{
public:
  explicit Contact_table(const Matching_problem& problem);

  // Lists what the energies of the next contact are the means of.
  void list(std::size_t contact);

  // Whether more is listed than stays in the cache.
  bool is_full() const { return comparisons_.size() > most_comparisons || piece_memory_.is_full(); }

  // Appends the energies of the contacts that were listed, in their order, first label by second label; the list is
  // empty then.
  void compute(std::vector<Rod_energy>& result);

private:
  using Range = internal::Fitted_range;
  using Fitted = internal::Fitted_piece;

  static constexpr std::uint32_t none = std::uint32_t(-1);
  static constexpr std::size_t most_comparisons = 8192; // what they compare stays in the cache

  // Rods of a source pair with those of a target pair; `next` is the next one with the same target pair.
  struct Comparison
  {
    const Structural_rods* rods;
    std::uint32_t next;
    Rod_energy energy;
  };

  // Two target pieces, each in an order of its samples: those of two fitted pieces.
  struct Target_pair
  {
    std::uint32_t first, second;
    std::uint32_t comparison; // the first of the list
  };

  // Clones are compared each with its nearest counterpart.
  void list(const Range& first, const Range& second);

  // The one of `others` that is nearest to a fitted piece.
  const std::uint32_t* nearest(std::uint32_t fitted, const Range& others);

  // The least distance of two target pieces, which is found once.
  double target_distance(const Fitted& first, const Fitted& second);

  std::uint32_t comparison(std::uint32_t a, std::uint32_t b);

  std::size_t pair_index(const Fitted& first, const Fitted& second) const;

  void compare();

  void list_ends(int side);

  const Structural_rods& rods(std::uint32_t a, std::uint32_t b);

  const Matching_problem& problem_;
  const internal::Fitted_pieces& fitted_;
  std::vector<std::uint32_t> pair_of_;       // by `pair_index()`, in `pairs_`
  std::vector<Target_pair> pairs_;           // those that anything is compared with
  std::vector<Comparison> comparisons_;      // of contact after contact
  std::vector<std::uint32_t> counts_;        // by contact and labels: how many comparisons
  std::vector<std::uint32_t> compared_;      // which ones, those of all labels in a row
  std::deque<Structural_rods> piece_rods_;   // between pieces of which one is no whole part
  internal::Rod_memory piece_memory_;        // where their directions are
  std::vector<const Structural_rods*> rods_; // that are compared with those of a target pair
  std::vector<double> distortions_;
  std::vector<std::vector<double>> distances_; // by target pieces; none where not asked for yet
  std::vector<std::uint32_t> nearest_;         // to the clones of a part

  // Of the contact that is being listed
  std::size_t contact_ = 0;
  std::array<std::size_t, 2> begin_, count_;         // the fitted pieces of either side
  std::array<std::vector<Range>, 2> touching_;       // by label
  std::vector<std::uint32_t> known_;                 // comparisons by two fitted pieces
  std::array<std::vector<std::size_t>, 2> ends_;     // samples of source pieces: rods are found once for two of them
  std::array<std::vector<std::size_t>, 2> end_of_;   // by fitted piece
  std::vector<const Structural_rods*> rods_of_ends_; // null where not found yet
};

} // namespace CGAL::Shape_correspondence
